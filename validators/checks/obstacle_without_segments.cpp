#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_obstacle_without_segments(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (!obstacles[i].segments.empty() || !context.is_complete(i)) continue;
    sink.obstacle(FindingCode::G112, i, ObstacleField::kSegmentCount,
                  name_of(obstacles[i]) + " has no segments; remove it, or add its outline");
  }
}

}  // namespace mapwright::validators
