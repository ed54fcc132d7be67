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
  AlignedInts number;             ///< 0, 1, …
  std::vector<Point> direction;   ///< unit vectors, double precision, without pads
  float half_fov = 0.0F;          ///< radians
  float rays_per_radian = 0.0F;   ///< 1 / step
  float half_past_middle = 0.0F;  ///< number of the ray straight ahead, were there one, and ½
  float max_range_m = 0.0F;

  /// The inverse range of a ray that nothing stops: so little below 1/RMAX that its reciprocal is
  /// longer than RMAX in all instruction sets, and becomes RMAX when ranges are cut there.
  float out_of_range = 0.0F;

  /// True for a field of view of at most 180°: no ray goes backwards.
  bool looks_ahead = false;
};

}  // namespace mapwright::navcore::engine
