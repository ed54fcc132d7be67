#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_implausible_tread(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    const auto risers = risers_of(stairs, flight);
    for (std::size_t n = 1; n < risers.size(); ++n) {
      const double tread = tread_m(stairs, risers[n - 1], risers[n]);
      if (options.min_step_tread_m <= tread && tread <= options.max_step_tread_m) continue;
      const std::size_t k = risers[n].pieces.front();
      sink.segment(FindingCode::T120, i, k,
                   name_of(stairs, k) + " lies " + metres(tread) +
                       " m behind the one below it; treads are between " +
                       metres(options.min_step_tread_m) + " m and " +
                       metres(options.max_step_tread_m) + " m");
    }
  });
}

}  // namespace mapwright::validators
