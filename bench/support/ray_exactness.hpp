// How exact a ray caster is, ray by ray, against double precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::bench {

/// A ray is grazing when moving it sideways by 10 µm changes its exact range by more than a ray
/// does that meets a segment at 2°: it meets one at less than 2°, or passes within 10 µm of an
/// edge.
inline constexpr double kSideways_m = 1e-5;
inline constexpr double kGrazing_deg = 2.0;

/// Greatest error of a ray that is not grazing. A grazing ray's range must lie within this of the
/// ranges between which moving it by 10 µm changes the exact one.
inline constexpr double kTolerance_m = 1e-4;

struct Exactness {
  std::size_t rays = 0;
  std::size_t stopped = 0;      ///< of them, before RMAX
  std::size_t grazing = 0;      ///< of those that were off by more than kCloseLook_m
  std::size_t wrong = 0;        ///< off by more than allowed
  double worst_error_m = 0.0;   ///< of rays that are not grazing
  double worst_scaled_m = 0.0;  ///< error × sine of the angle at which the segment is met
  std::string first_wrong;      ///< pose and ray, for the person who has to find out why

  void add(const Exactness& other);
};

/// Errors below this are not looked at closely (metres).
inline constexpr double kCloseLook_m = 1e-5;

/// Casts a scan from each pose and compares. `reference` is a double-precision caster of the same
/// map; of rays that are off, the map itself is asked.
Exactness measure_exactness(const Map& map, const navcore::RayCaster& caster,
                            const navcore::RayCaster& reference, std::span<const Pose> poses,
                            const navcore::LaserModel& laser);

/// Poses all over the map and a little beyond, in solids and on walls too; a tenth at whole
/// decimetres, a tenth with headings along the axes.
std::vector<Pose> poses_everywhere(const Map& map, std::size_t count, std::uint64_t seed);

/// Poses as a filter has them that tracks: 24 around one place (0.3 m, 3°), then 24 around another;
/// in every fourth such cluster the headings are any. The places are poses_everywhere().
std::vector<Pose> poses_in_clusters(const Map& map, std::size_t count, std::uint64_t seed);

}  // namespace mapwright::bench
