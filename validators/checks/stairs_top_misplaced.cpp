#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/shape/flight.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

Point middle(const Segment& segment) {
  return 0.5 * (segment.a + segment.b);
}

// Position of the highest step among the steps.
std::size_t highest(const Flight& flight) {
  return flight.rises ? flight.steps.size() - 1 : 0;
}

// Steps that are drawn the other way round are T106.
double behind_m(const Segment& step, bool faces_as_most, Point p) {
  const double left_m = validators::behind_m(step, p);
  return faces_as_most ? left_m : -left_m;
}

}  // namespace

void check_stairs_top_misplaced(const CheckContext& context, FindingSink& sink) {
  const auto& options = context.options();
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    if (!flight.top) return;
    const std::size_t n = highest(flight);
    const double behind = behind_m(stairs.segments[flight.steps[n]], flight.faces_as_most[n],
                                   middle(stairs.segments[*flight.top]));
    // On the highest step it may lie, up to the rounding of both.
    if (-options.overlap_depth_m <= behind && behind <= options.max_step_tread_m) return;
    sink.segment(
        FindingCode::T125, i, *flight.top,
        name_of(stairs, *flight.top) + " closes the stairs but lies " +
            (behind < 0.0 ? metres(-behind) + " m in front of" : metres(behind) + " m behind") +
            " the highest step; it belongs at the upper edge of the last tread");
  });
}

}  // namespace mapwright::validators
