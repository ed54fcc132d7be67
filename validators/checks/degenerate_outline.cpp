#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_degenerate_outline(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    const Outline& outline = context.outline(i);
    if (!is_closed(obstacles[i].shape_type) || !outline.is_flat || !outline.closes ||
        !context.is_complete(i)) {
      continue;
    }
    sink.obstacle(FindingCode::G110, i, ObstacleField::kShapeType,
                  name_of(obstacles[i]) +
                      " is a closed shape, but all its points lie on one line; make it an open "
                      "shape, or give it its third corner");
  }
}

}  // namespace mapwright::validators
