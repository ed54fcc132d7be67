#include "validators/check.hpp"
#include "validators/shape/outline.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_sliver(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  const double limit_m = context.options().sliver_width_m;
  for (const auto i : context.in_doubt(Doubt::kChain)) {
    const Outline& outline = context.outline(i);
    if (!outline.is_ring) continue;
    const double width_m = mean_width_m(outline);
    if (width_m > limit_m) continue;
    sink.obstacle(FindingCode::G122, i, ObstacleField::kKeyword,
                  name_of(obstacles[i]) + " is " + metres(width_m) +
                      " m wide on average, at most " + metres(limit_m) +
                      " m; remove it, or draw it as an open wall");
  }
}

}  // namespace mapwright::validators
