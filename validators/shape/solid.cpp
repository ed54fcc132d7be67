#include "validators/shape/solid.hpp"

#include <algorithm>

namespace mapwright::validators {
namespace {

bool is_high(const Segment& segment) {
  return segment.height_m > 0.0;
}

}  // namespace

Body body_of(const CheckContext& context, std::size_t i) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const Outline& outline = context.outline(i);
  const auto& segments = obstacle.segments;
  if (obstacle.shape_type == ShapeType::kRamp ||
      !std::any_of(segments.begin(), segments.end(), is_high)) {
    return Body::kNone;
  }
  if (!outline.is_ring || !std::all_of(segments.begin(), segments.end(), is_high)) {
    return Body::kWall;
  }
  if (outline.is_counter_clockwise_ring()) return Body::kSolid;
  const auto holder = context.nesting().holder(i);
  const bool in_solid = holder && context.outline(*holder).is_counter_clockwise_ring();
  return in_solid ? Body::kHole : Body::kRoom;
}

Region::Region(const CheckContext& context, std::uint32_t outer, std::vector<std::uint32_t> holes)
    : context_(context), outer_(outer) {
  if (holes.empty()) return;
  std::vector<IndexedSegment> diagonals;
  diagonals.reserve(holes.size());
  for (const auto hole : holes) {
    const Box& box = context.box(hole);
    diagonals.push_back({{box.min_x, box.min_y}, {box.max_x, box.max_y}, hole});
  }
  holes_ = std::make_shared<SegmentIndex>(std::move(diagonals));
}

void Region::for_each_hole(const Box& box, const std::function<void(std::uint32_t)>& visit) const {
  if (!holes_) return;
  holes_->query(box, [&](std::size_t k) {
    visit((*holes_)[k].tag);
    return true;
  });
}

bool Region::holds(Point p, double depth_m) const {
  if (!context_.box(outer_).contains(p)) return false;
  const EdgeFinder& outer = context_.edges(outer_);
  if (outer.side(p) != PointSide::kInside || outer.distance_m(p) <= depth_m) return false;
  bool is_free = false;
  for_each_hole(Box{p.x, p.y, p.x, p.y}.inflated(depth_m), [&](std::uint32_t hole) {
    const EdgeFinder& edges = context_.edges(hole);
    is_free = is_free || edges.side(p) != PointSide::kOutside || edges.distance_m(p) <= depth_m;
  });
  return !is_free;
}

Region region_of(const CheckContext& context, std::uint32_t solid) {
  std::vector<std::uint32_t> holes;
  for (const auto held : context.nesting().held(solid)) {
    if (body_of(context, held) == Body::kHole) holes.push_back(held);
  }
  return Region(context, solid, std::move(holes));
}

}  // namespace mapwright::validators
