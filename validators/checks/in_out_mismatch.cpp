#include <algorithm>
#include <optional>

#include "validators/check.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

// Nothing where the obstacle has both.
std::optional<InOut> side_of(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  if (segments.empty()) return std::nullopt;
  const InOut first = segments.front().in_out;
  const bool same = std::all_of(segments.begin(), segments.end(),
                                [&](const Segment& s) { return s.in_out == first; });
  return same ? std::optional(first) : std::nullopt;
}

std::string name_of(InOut side) {
  return side == InOut::kIndoor ? "indoor" : "outdoor";
}

}  // namespace

// Rooms and courtyards are clockwise rings: what stands in them is where they are.
void check_in_out_mismatch(const CheckContext& context, FindingSink& sink) {
  const auto& obstacles = context.map().obstacles;
  for (const auto i : context.nesting().held_obstacles()) {
    const auto holder = context.nesting().holder(i);
    if (!holder || !context.outline(*holder).is_clockwise_ring()) continue;
    const auto side = side_of(obstacles[i]), around = side_of(obstacles[*holder]);
    if (!side || !around || *side == *around) continue;
    sink.segment(FindingCode::S126, i, 0, SegmentField::kInOut, obstacles[i].segments.front().a,
                 validators::name_of(obstacles[i]) + " is " + name_of(*side) + " but stands in " +
                     validators::name_of(obstacles[*holder]) + ", which is " + name_of(*around) +
                     "; correct inOut of one of them");
  }
}

}  // namespace mapwright::validators
