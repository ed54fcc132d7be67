#include <cmath>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/shape/line_angle.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

std::string degrees(double value) {
  return std::to_string(std::lround(value)) + "°";
}

}  // namespace

void check_stairs_steps_not_parallel(const CheckContext& context, FindingSink& sink) {
  const double limit_deg = context.options().max_step_turn_deg;
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    for (std::size_t n = 1; n < flight.steps.size(); ++n) {
      const std::size_t k = flight.steps[n];
      const double angle_deg =
          line_angle_deg(stairs.segments[flight.steps[n - 1]], stairs.segments[k]);
      if (angle_deg <= limit_deg) continue;
      sink.segment(FindingCode::T105, i, k,
                   name_of(stairs, k) + " is turned by " + degrees(angle_deg) +
                       " against the step before it, more than " + degrees(limit_deg) +
                       "; move its ends, or make two flights of the stairs");
    }
  });
}

}  // namespace mapwright::validators
