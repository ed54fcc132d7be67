#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_implausible_rise(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    std::vector<std::size_t> upwards = flight.steps;
    if (!flight.rises) std::reverse(upwards.begin(), upwards.end());
    double below_m = 0.0;
    for (const std::size_t k : upwards) {
      const double height_m = stairs.segments[k].height_m;
      const double rise_m = height_m - below_m;
      below_m = height_m;
      // Heights that fall, or are equal for steps one behind the other, are errors of order (T101).
      if (rise_m <= 0.0 || height_m < 0.0) continue;
      if (options.min_step_rise_m <= rise_m && rise_m <= options.max_step_rise_m) continue;
      sink.segment(FindingCode::T104, i, k, SegmentField::kHeight, stairs.segments[k].a,
                   name_of(stairs, k) + " rises " + metres(rise_m) +
                       " m above the one below it; steps rise between " +
                       metres(options.min_step_rise_m) + " m and " +
                       metres(options.max_step_rise_m) + " m");
    }
  });
}

}  // namespace mapwright::validators
