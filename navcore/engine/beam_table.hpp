// Private to this folder: directions of a laser's rays, laid out for the kernels.
#pragma once

#include <cstddef>
#include <vector>

#include "navcore/engine/aligned.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore::engine {

/// The rays of a laser in the sensor frame (x ahead). Single-precision arrays are padded to
/// `padded_rays()`, whole blocks and one more, with rays that nothing meets.
struct BeamTable {
  explicit BeamTable(const LaserModel& laser);

  std::size_t padded_rays() const { return cosine.size(); }

  std::size_t rays = 0;
  AlignedFloats cosine, sine;
  AlignedFloats bearing;         ///< radians in [−π, π], ascending; pads are far beyond
  std::vector<Point> direction;  ///< unit vectors, double precision, without pads
  float half_fov = 0.0F;         ///< radians
  float rays_per_radian = 0.0F;  ///< 1 / step
  float max_range_m = 0.0F;
  float inverse_max_range = 0.0F;
};

}  // namespace mapwright::navcore::engine
