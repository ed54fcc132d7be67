#include <cmath>
#include <numbers>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_ramp_too_steep(const CheckContext& context, FindingSink& sink) {
  for_each_ramp(context, [&](const Obstacle& ramp, std::size_t i) {
    const auto normal = ramp_normal(ramp);
    if (!normal || !(normal->z > 0.0)) return;
    const double slope_deg =
        std::atan2(std::hypot(normal->x, normal->y), normal->z) * 180.0 / std::numbers::pi;
    const double limit_deg = context.options().max_ramp_slope_deg;
    if (slope_deg <= limit_deg) return;
    sink.obstacle(FindingCode::T204, i, ObstacleField::kSemantic,
                  name_of(ramp) + " rises at " + metres(slope_deg) + "°, more than " +
                      metres(limit_deg) + "°; correct its normal, or make it stairs or a wall");
  });
}

}  // namespace mapwright::validators
