#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Height of the highest vertex above the lowest.
double rise_m(const Obstacle& ramp, const Normal& normal) {
  const auto footprint = chain_points(ramp);
  const RampPlane plane(normal, footprint);
  double highest_m = 0.0;
  for (const Point p : footprint) highest_m = std::max(highest_m, plane.height_m(p));
  return highest_m;
}

}  // namespace

void check_ramp_implausible_rise(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_ramp(context, [&](const Obstacle& ramp, std::size_t i) {
    const auto normal = ramp_normal(ramp);
    if (!normal || !(normal->z > 0.0)) return;  // T201 and T202 tell
    const double rise = rise_m(ramp, *normal);
    if (options.min_ramp_rise_m <= rise && rise <= options.max_ramp_rise_m) return;
    sink.obstacle(FindingCode::T130, i, ObstacleField::kSemantic,
                  name_of(ramp) + " rises " + metres(rise) +
                      " m from end to end; ramps rise between " + metres(options.min_ramp_rise_m) +
                      " m and " + metres(options.max_ramp_rise_m) + " m; correct its normal");
  });
}

}  // namespace mapwright::validators
