// The report's ray caster: obstacles culled by their bounding circles.
#pragma once

#include <cstddef>
#include <memory>

#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

/// Ray casting as the report has it (section 4.1): when the map is loaded, each obstacle gets its
/// minimum bounding circle; a scan first drops every obstacle whose circle does not meet the scan's
/// sector (the report's semicircle of radius RMAX, here of any field of view), then tests each ray
/// against each segment of the others. Rules in docs/rays.md.
///
/// Cost: one circle test for each obstacle of the map, then rays × surviving segments.
class CulledRayCaster : public RayCaster {
 public:
  explicit CulledRayCaster(const Map& map);
  CulledRayCaster(CulledRayCaster&&) noexcept;
  CulledRayCaster& operator=(CulledRayCaster&&) noexcept;
  ~CulledRayCaster() override;

  void cast(const Pose& pose, const LaserModel& laser, std::span<double> ranges) const override;
  void cast_all(std::span<const Pose> poses, const LaserModel& laser,
                std::span<double> ranges) const override;

 private:
  struct Obstacles;
  std::unique_ptr<const Obstacles> obstacles_;
};

}  // namespace mapwright::navcore
