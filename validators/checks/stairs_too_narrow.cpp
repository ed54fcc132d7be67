#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_too_narrow(const CheckContext& context, FindingSink& sink) {
  const double limit_m = context.options().min_step_width_m;
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    for (const Riser& riser : risers_of(stairs, flight)) {
      if (riser.width_m >= limit_m) continue;
      const std::size_t k = riser.pieces.front();
      sink.segment(FindingCode::T123, i, k,
                   name_of(stairs, k) + " is a step " + metres(riser.width_m) +
                       " m wide, less than " + metres(limit_m) +
                       " m; correct its ends, or draw a wall");
    }
  });
}

}  // namespace mapwright::validators
