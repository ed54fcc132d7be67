// The report's ray casting as section 4.1 writes it down, to compare with.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mapcore/geometry/bounding_circle.hpp"
#include "mapcore/map.hpp"
#include "navcore/rays/laser.hpp"
#include "navcore/rays/ramp_slope.hpp"

namespace mapwright::bench {

/// Word for word: when the map is loaded, each obstacle gets its minimum bounding circle; for each
/// scan, one test between the scanner's (semi)circle and that circle of each obstacle; then each
/// ray is intersected with each segment of the obstacles left. Nothing is reordered, batched or
/// culled beyond that. Rules of docs/rays.md in double precision.
///
/// `navcore::CulledRayCaster` is the same method written for speed: it drops low obstacles and far
/// segments before any ray is cast, and takes all rays of a scan to a segment at once.
class ReportRays final : public navcore::RayCaster {
 public:
  explicit ReportRays(const Map& map);

  void cast(const Pose& pose, const navcore::LaserModel& laser,
            std::span<double> ranges) const override;
  void cast_all(std::span<const Pose> poses, const navcore::LaserModel& laser,
                std::span<double> ranges) const override;

  /// An obstacle as loaded.
  struct Body {
    Circle circle;
    Obstacle obstacle;
    std::optional<navcore::RampSlope> slope;  ///< of ramps
  };

 private:
  std::vector<Body> bodies_;
};

}  // namespace mapwright::bench
