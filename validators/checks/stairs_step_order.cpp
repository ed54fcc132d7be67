#include "validators/check.hpp"
#include "validators/shape/each_of_kind.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Closing segments that are not the one beside the highest step, where there is such a one; those
// at the ends of a flight without it are told of by T102.
void check_closing_segments(const Obstacle& stairs, std::size_t i, const Flight& flight,
                            FindingSink& sink) {
  for (const std::size_t k : flight.closing) {
    const bool stands_at_an_end = k < flight.steps.front() || k > flight.steps.back();
    if (k == flight.top || (!flight.top && stands_at_an_end)) continue;
    sink.segment(FindingCode::T101, i, k, SegmentField::kHeight, stairs.segments[k].a,
                 name_of(stairs, k) +
                     " has height 0 among steps; only the closing segment beside "
                     "the highest step has that height");
  }
}

void check_heights(const Obstacle& stairs, std::size_t i, const Flight& flight, FindingSink& sink) {
  for (std::size_t n = 1; n < flight.steps.size(); ++n) {
    const std::size_t k = flight.steps[n];
    const Segment& below = stairs.segments[flight.steps[n - 1]];
    const double before = below.height_m;
    const double height = stairs.segments[k].height_m;
    if (height == before && stand_side_by_side(below, stairs.segments[k])) continue;
    if (flight.rises ? height > before : height < before) continue;
    sink.segment(FindingCode::T101, i, k, SegmentField::kHeight, stairs.segments[k].a,
                 name_of(stairs, k) + " is " + metres(height) + " m high behind a step of " +
                     metres(before) + " m, though the flight " +
                     (flight.rises ? "rises" : "falls") +
                     "; put the steps in order, or correct the height");
  }
}

}  // namespace

void check_stairs_step_order(const CheckContext& context, FindingSink& sink) {
  for_each_stairs(context, [&](const Obstacle& stairs, std::size_t i, const Flight& flight) {
    if (flight.steps.empty()) {
      sink.obstacle(FindingCode::T101, i, ObstacleField::kSegmentCount,
                    name_of(stairs) +
                        " is a flight of stairs without step; every segment has "
                        "height 0");
      return;
    }
    check_closing_segments(stairs, i, flight, sink);
    check_heights(stairs, i, flight, sink);
  });
}

}  // namespace mapwright::validators
