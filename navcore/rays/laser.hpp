// The planar laser scanner and what casts its rays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mapcore/angle.hpp"

namespace mapwright::navcore {

/// Geometry of a planar laser scanner. The defaults are the report's (section 4.1); the report does
/// not print field of view and mounting height, so those two are this project's.
struct LaserModel {
  std::size_t rays = 131;     ///< NL
  double fov_deg = 180.0;     ///< in (0, 360]
  double max_range_m = 15.0;  ///< RMAX
  double height_m = 0.5;      ///< hL, above the ground the robot stands on
};

/// Direction of ray i relative to the heading, degrees counter-clockwise: from −fov/2 to +fov/2
/// inclusive. A single ray looks straight ahead.
constexpr double ray_angle_deg(const LaserModel& laser, std::size_t i) {
  if (laser.rays <= 1) return 0.0;
  return laser.fov_deg * (static_cast<double>(i) / static_cast<double>(laser.rays - 1) - 0.5);
}

/// Synthesises range readings from a map (report, section 4.1, figure 6; rules in
/// docs/rays.md). Immutable once built; safe to use from many threads.
class RayCaster {
 public:
  virtual ~RayCaster() = default;

  /// Ranges (metres, in [0, max_range_m]) of one scan, taken at laser.height_m; `max_range_m` where
  /// nothing stops the ray. Requires ranges.size() == laser.rays.
  virtual void cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const = 0;

  /// One scan from each pose, one after the other in `ranges`: the numbers `cast` gives, but what
  /// depends on the laser alone is computed once. Requires ranges.size() == poses.size() ×
  /// laser.rays.
  virtual void cast_all(std::span<const Pose> poses, const LaserModel& laser,
                        std::span<double> ranges) const {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      cast(poses[i], laser, ranges.subspan(i * laser.rays, laser.rays));
    }
  }
};

}  // namespace mapwright::navcore
