#include <cmath>

#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/shape/line_angle.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {

void check_stairs_top_not_parallel(const CheckContext& context, FindingSink& sink) {
  const double limit_deg = context.options().max_step_turn_deg;
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    if (!flight.top) return;
    const std::size_t highest = flight.rises ? flight.steps.back() : flight.steps.front();
    const double angle_deg = line_angle_deg(stairs.segments[highest], stairs.segments[*flight.top]);
    if (angle_deg <= limit_deg) return;
    sink.segment(FindingCode::T126, i, *flight.top,
                 name_of(stairs, *flight.top) + " closes the stairs but is turned by " +
                     std::to_string(std::lround(angle_deg)) +
                     "° against the highest step; move its ends");
  });
}

}  // namespace mapwright::validators
