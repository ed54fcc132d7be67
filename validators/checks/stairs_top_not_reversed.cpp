#include "validators/check.hpp"
#include "validators/repairs.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

Point direction(const Segment& segment) {
  return segment.b - segment.a;
}

}  // namespace

void check_stairs_top_not_reversed(const CheckContext& context, FindingSink& sink) {
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    if (!flight.top) return;
    const std::size_t n = flight.rises ? flight.steps.size() - 1 : 0;
    const Segment& highest = stairs.segments[flight.steps[n]];
    const bool runs_like_it =
        dot(direction(stairs.segments[*flight.top]), direction(highest)) > 0.0;
    if (runs_like_it != flight.faces_as_most[n]) return;
    sink.segment(
        FindingCode::T103, i, *flight.top,
        name_of(stairs, *flight.top) + " closes the stairs but runs like the steps; swap its ends");
    sink.fix(swapped_ends(context.document(), i, *flight.top));
  });
}

}  // namespace mapwright::validators
