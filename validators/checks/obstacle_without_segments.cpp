#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_obstacle_without_segments(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kEmpty)) {
    if (!obstacles[i].segments.empty() || !context.is_complete(i)) continue;
    sink.obstacle(FindingCode::G112, i, ObstacleField::kSegmentCount,
                  name_of(obstacles[i]) + " has no segments; remove it, or add its outline");
  }
}

}  // namespace mapwright::validators
