#include "validators/shape/nesting.hpp"

#include <algorithm>

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
  const Outline& outer = context.outline(ring);
  const Outline& inner = context.outline(obstacle);
  if (ring == obstacle || !outer.is_ring || inner.box.is_empty()) return false;
  const double slack_m = context.options().overlap_depth_m;
  if (!lies_in_box(inner.box, outer.box.inflated(slack_m))) return false;
  if (inner.is_ring && inner.area_m2 >= outer.area_m2) return false;
  const Point p = probe(context.map().obstacles[obstacle], inner);
  return context.edges(ring).side(p) == PointSide::kInside;
}

Nesting::Nesting(const CheckContext& context) {
  const auto consider = [&](std::uint32_t ring, std::uint32_t obstacle) {
    const auto old = holder_.find(obstacle);
    if (old != holder_.end() &&
        context.outline(old->second).area_m2 <= context.outline(ring).area_m2) {
      return;
    }
    if (holds(context, ring, obstacle)) holder_[obstacle] = ring;
  };
  for (const auto [first, second] : context.meeting_pairs()) {
    consider(first, second);
    consider(second, first);
  }
  for (const auto& [obstacle, ring] : holder_) {
    held_obstacles_.push_back(static_cast<std::uint32_t>(obstacle));
  }
  std::sort(held_obstacles_.begin(), held_obstacles_.end());
  for (const auto obstacle : held_obstacles_) held_[holder_[obstacle]].push_back(obstacle);
  for (const auto& [ring, held] : held_) holders_.push_back(static_cast<std::uint32_t>(ring));
  std::sort(holders_.begin(), holders_.end());
}

std::optional<std::size_t> Nesting::holder(std::size_t obstacle) const {
  const auto found = holder_.find(obstacle);
  if (found == holder_.end()) return std::nullopt;
  return found->second;
}

const std::vector<std::uint32_t>& Nesting::held(std::size_t ring) const {
  const auto found = held_.find(ring);
  return found == held_.end() ? none_ : found->second;
}

}  // namespace mapwright::validators
