#include "validators/shape/solid.hpp"

#include <algorithm>

namespace mapwright::validators {
namespace {

bool is_high(const Segment& segment) {
  return segment.height_m > 0.0;
}

Body body_of(const CheckContext& context, std::size_t i) {
  const Obstacle& obstacle = context.map().obstacles[i];
  const Outline& outline = context.outlines()[i];
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
  const bool in_solid = holder && context.outlines()[*holder].is_counter_clockwise_ring();
  return in_solid ? Body::kHole : Body::kRoom;
}

}  // namespace

std::vector<Body> bodies_of(const CheckContext& context) {
  std::vector<Body> bodies;
  bodies.reserve(context.map().obstacles.size());
  for (std::size_t i = 0; i < context.map().obstacles.size(); ++i) {
    bodies.push_back(body_of(context, i));
  }
  return bodies;
}

bool Region::holds(Point p, double depth_m) const {
  for (const auto outline : outlines_) {
    const bool is_outer = outline == outer();
    if (!context_.outlines()[outline].box.contains(p)) {
      if (is_outer) return false;
      continue;
    }
    const EdgeFinder& edges = context_.edges(outline);
    if (edges.side(p) != (is_outer ? PointSide::kInside : PointSide::kOutside)) return false;
    if (edges.distance_m(p) <= depth_m) return false;
  }
  return true;
}

}  // namespace mapwright::validators
