#include "cli/support/blind_laser.hpp"

#include <algorithm>

#include "navcore/rays/ramp_slope.hpp"
#include "validators/wording.hpp"

namespace mapwright::cli {
namespace {

bool is_seen(const Obstacle& obstacle, double laser_height_m) {
  if (obstacle.shape_type == ShapeType::kRamp) {
    const auto slope = navcore::RampSlope::of(obstacle);
    return slope && !slope->contour(laser_height_m).pieces.empty();
  }
  return std::any_of(obstacle.segments.begin(), obstacle.segments.end(),
                     [&](const Segment& s) { return s.height_m > laser_height_m; });
}

}  // namespace

void warn_of_blind_laser(const Map& map, double laser_height_m, Console& console) {
  if (std::any_of(map.obstacles.begin(), map.obstacles.end(),
                  [&](const Obstacle& o) { return is_seen(o, laser_height_m); })) {
    return;
  }
  console.warning("nothing on the map is higher than the laser at " +
                  validators::metres(laser_height_m) +
                  " m (--laser-height): its rays meet nothing, and scans tell nothing");
}

}  // namespace mapwright::cli
