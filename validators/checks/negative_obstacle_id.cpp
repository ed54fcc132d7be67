#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_negative_obstacle_id(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kNegativeId)) {
    if (obstacles[i].id >= 0) continue;
    sink.obstacle(FindingCode::S102, i, ObstacleField::kId,
                  name_of(obstacles[i]) + " has an id below zero; number obstacles from 0 or 1 on");
  }
}

}  // namespace mapwright::validators
