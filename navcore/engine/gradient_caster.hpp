// Casts scans together with their derivatives with respect to the robot's pose.
#pragma once

#include <memory>
#include <span>

#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

/// A ray's range, and how it changes as the robot moves.
struct RangeGradient {
  double range_m = 0.0;   ///< in [0, max_range_m]
  double by_x = 0.0;      ///< metres a metre along the map's x
  double by_y = 0.0;      ///< metres a metre along the map's y
  double by_theta = 0.0;  ///< metres a radian of heading, the ray turning with it
  bool echo = false;      ///< false: nothing within range, and no derivative
};

/// Ranges by the rules of docs/rays.md, in double precision, and their analytic derivatives.
///
/// In a frame that is centred on the laser a wall lies on the line n·p = 1, so that the range along
/// the unit vector u is r = 1/(n·u) and
///
///     ∂r/∂(x, y) = −r n,     ∂r/∂θ = −r² (n·u⊥),     u⊥ = u turned left by 90°.
///
/// They hold as long as the ray keeps to the same wall; at the edge of a wall, where the range
/// jumps, there is none. A wall whose line passes through the laser is seen end on and stops no
/// ray, unlike in the ray casters. Immutable; safe to use from many threads.
class GradientCaster {
 public:
  explicit GradientCaster(const Map& map);
  GradientCaster(GradientCaster&&) noexcept;
  GradientCaster& operator=(GradientCaster&&) noexcept;
  ~GradientCaster();

  /// One scan. Requires gradients.size() == laser.rays.
  void cast(const Pose& pose, const LaserModel& laser, std::span<RangeGradient> gradients) const;

  /// One scan from each pose, one after the other in `gradients`: the numbers `cast` gives, faster
  /// for poses beside each other, which look for their walls together.
  void cast_all(std::span<const Pose> poses, const LaserModel& laser,
                std::span<RangeGradient> gradients) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace mapwright::navcore
