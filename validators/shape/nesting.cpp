#include "validators/shape/nesting.hpp"

#include "validators/check.hpp"

namespace mapwright::validators {
namespace {

bool lies_in_box(const Box& inner, const Box& outer) {
  return outer.min_x <= inner.min_x && inner.max_x <= outer.max_x && outer.min_y <= inner.min_y &&
         inner.max_y <= outer.max_y;
}

Point probe(const Obstacle& obstacle, const Outline& outline) {
  if (outline.is_ring) return point_inside(obstacle);
  const auto& first = obstacle.segments.front();
  return 0.5 * first.a + 0.5 * first.b;
}

}  // namespace

bool holds(const CheckContext& context, std::size_t ring, std::size_t obstacle) {
  const Outline& outer = context.outlines()[ring];
  const Outline& inner = context.outlines()[obstacle];
  if (ring == obstacle || !outer.is_ring || inner.box.is_empty()) return false;
  const double slack_m = context.options().overlap_depth_m;
  if (!lies_in_box(inner.box, outer.box.inflated(slack_m))) return false;
  if (inner.is_ring && inner.area_m2 >= outer.area_m2) return false;
  const Point p = probe(context.map().obstacles[obstacle], inner);
  return context.edges(ring).side(p) == PointSide::kInside;
}

Nesting::Nesting(const CheckContext& context)
    : holder_(context.map().obstacles.size(), kNone), held_(context.map().obstacles.size()) {
  const auto& outlines = context.outlines();
  const auto consider = [&](std::uint32_t ring, std::uint32_t obstacle) {
    const std::uint32_t old = holder_[obstacle];
    if (old != kNone && outlines[old].area_m2 <= outlines[ring].area_m2) return;
    if (holds(context, ring, obstacle)) holder_[obstacle] = ring;
  };
  for (const auto [first, second] : context.meeting_pairs()) {
    consider(first, second);
    consider(second, first);
  }
  for (std::uint32_t i = 0; i < holder_.size(); ++i) {
    if (holder_[i] != kNone) held_[holder_[i]].push_back(i);
  }
}

std::optional<std::size_t> Nesting::holder(std::size_t obstacle) const {
  if (holder_[obstacle] == kNone) return std::nullopt;
  return holder_[obstacle];
}

const std::vector<std::uint32_t>& Nesting::held(std::size_t ring) const {
  return held_[ring];
}

}  // namespace mapwright::validators
