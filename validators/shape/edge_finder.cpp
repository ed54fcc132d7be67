#include "validators/shape/edge_finder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mapwright::validators {
namespace {

// Up to this many segments, looking at all of them costs less than an index.
constexpr std::size_t kFewSegments = 48;

std::shared_ptr<const SegmentIndex> index_over(const Obstacle& obstacle) {
  std::vector<IndexedSegment> segments;
  segments.reserve(obstacle.segments.size());
  for (std::size_t i = 0; i < obstacle.segments.size(); ++i) {
    const auto& segment = obstacle.segments[i];
    if (segment.a == segment.b) continue;
    segments.push_back({segment.a, segment.b, static_cast<std::uint32_t>(i)});
  }
  return std::make_shared<SegmentIndex>(std::move(segments));
}

// A segment owns its lower end only, so that a ray through a vertex is counted once.
bool crosses_ray_to_the_right(Point a, Point b, Point p) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  return turn(a, b, p) == (b.y > a.y ? Turn::kLeft : Turn::kRight);
}

}  // namespace

EdgeFinder::EdgeFinder(const Obstacle& obstacle) : obstacle_(&obstacle) {
  if (obstacle.segments.size() > kFewSegments) index_ = index_over(obstacle);
}

PointSide EdgeFinder::side(Point p) const {
  bool inside = false;
  bool on_boundary = false;
  visit({p.x, p.y, HUGE_VAL, p.y}, [&](std::uint32_t i) {
    const auto [a, b] = ends(i);
    if (crosses_ray_to_the_right(a, b, p)) inside = !inside;
    on_boundary = on_boundary || meet(p, p, a, b).kind != Meeting::kNone;
  });
  if (on_boundary) return PointSide::kBoundary;
  return inside ? PointSide::kInside : PointSide::kOutside;
}

double EdgeFinder::distance_m(Point p) const {
  if (index_) {
    const auto nearest = index_->nearest(p);
    return nearest ? nearest->distance_m : HUGE_VAL;
  }
  double squared = HUGE_VAL;
  for (const auto& segment : obstacle_->segments) {
    const Point q = closest_point_on_segment(p, segment.a, segment.b);
    squared = std::min(squared, squared_length(q - p));
  }
  return std::sqrt(squared);
}

}  // namespace mapwright::validators
