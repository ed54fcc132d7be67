#include "validators/check.hpp"
#include "validators/repairs.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_steps_oppose(const CheckContext& context, FindingSink& sink) {
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    for (std::size_t n = 0; n < flight.steps.size(); ++n) {
      if (flight.faces_as_most[n]) continue;
      sink.segment(FindingCode::T106, i, flight.steps[n],
                   name_of(stairs, flight.steps[n]) +
                       " is a step that faces the other way than most; swap its ends");
      sink.fix(swapped_ends(context.document(), i, flight.steps[n]));
    }
  });
}

}  // namespace mapwright::validators
