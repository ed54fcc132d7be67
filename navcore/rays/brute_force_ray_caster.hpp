// The plainest ray caster: every ray against every segment.
#pragma once

#include <vector>

#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

/// Tests each ray against each segment of the map, in double precision, by the rules of
/// docs/rays.md written down as directly as possible. What faster ray casters are compared with;
/// it shares no geometry with them but the directions of the rays.
class BruteForceRayCaster : public RayCaster {
 public:
  explicit BruteForceRayCaster(const Map& map) : obstacles_(map.obstacles) {}

  void cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const override;

  /// Range of the ray from `origin` along the unit vector `direction`.
  double cast_ray(Point origin, Point direction, double height_m, double max_range_m) const;

 private:
  std::vector<Obstacle> obstacles_;
};

}  // namespace mapwright::navcore
