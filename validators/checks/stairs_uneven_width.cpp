#include <algorithm>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

// Fans and amphitheatres widen from step to step, but not by half of themselves.
void check_stairs_uneven_width(const CheckContext& context, FindingSink& sink) {
  const double limit = context.options().max_width_ratio;
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    const auto risers = risers_of(stairs, flight);
    for (std::size_t n = 1; n < risers.size(); ++n) {
      const double width_m = risers[n].width_m, below_m = risers[n - 1].width_m;
      if (std::max(width_m, below_m) <= limit * std::min(width_m, below_m)) continue;
      const std::size_t k = risers[n].pieces.front();
      sink.segment(FindingCode::T124, i, k,
                   name_of(stairs, k) + " is a step " + metres(width_m) + " m wide above one of " +
                       metres(below_m) + " m; correct its ends, or make two flights of the stairs");
    }
  });
}

}  // namespace mapwright::validators
