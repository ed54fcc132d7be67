#include "validators/shape/outline.hpp"

#include <cassert>
#include <tuple>
#include <vector>

namespace mapwright::validators {
namespace {

bool is_joined(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (segments[i - 1].b != segments[i].a) return false;
  }
  return true;
}

// Start points of the segments that have a length.
std::vector<Point> vertices(const Obstacle& ring) {
  std::vector<Point> points;
  points.reserve(ring.segments.size());
  for (const auto& segment : ring.segments) {
    if (segment.a != segment.b) points.push_back(segment.a);
  }
  return points;
}

bool is_flat(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  const Point a = segments.front().a;
  Point b = a;
  for (const auto& segment : segments) {
    for (const Point p : {segment.a, segment.b}) {
      if (a == b) b = p;
      if (turn(a, b, p) != Turn::kStraight) return false;
    }
  }
  return true;
}

std::size_t lexicographically_first(const std::vector<Point>& points) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (std::tie(points[i].x, points[i].y) < std::tie(points[first].x, points[first].y)) first = i;
  }
  return first;
}

bool in_triangle(Point p, Point a, Point b, Point c) {
  const Turn side = turn(a, b, c);
  return turn(a, b, p) == side && turn(b, c, p) == side && turn(c, a, p) == side;
}

// The vertex in the triangle before, v, after that lies farthest from the line before–after; v's
// opposite side where the triangle is empty.
Point opposite_of(const std::vector<Point>& points, Point before, Point v, Point after) {
  Point opposite = 0.5 * before + 0.5 * after;
  double farthest = 0.0;
  for (const Point p : points) {
    if (!in_triangle(p, before, v, after)) continue;
    const double distance = std::abs(cross(after - before, p - before));
    if (distance > farthest) {
      farthest = distance;
      opposite = p;
    }
  }
  return opposite;
}

}  // namespace

Outline outline_of(const Obstacle& obstacle) {
  Outline outline;
  if (obstacle.segments.empty()) return outline;
  outline.box = extent(obstacle);
  outline.is_joined = is_joined(obstacle);
  outline.closes = obstacle.segments.back().b == obstacle.segments.front().a;
  outline.is_flat = is_flat(obstacle);
  if (!is_closed(obstacle.shape_type) || !outline.is_joined || !outline.closes || outline.is_flat) {
    return outline;
  }
  const auto points = vertices(obstacle);
  outline.is_ring = is_simple_ring(points);
  if (!outline.is_ring) return outline;
  outline.orientation = ring_orientation(points);
  outline.area_m2 = std::abs(signed_area_m2(points));
  for (const auto& segment : obstacle.segments)
    outline.perimeter_m += distance(segment.a, segment.b);
  return outline;
}

Point point_inside(const Obstacle& ring) {
  const auto points = vertices(ring);
  assert(points.size() >= 3);
  const std::size_t corner = lexicographically_first(points);
  const Point before = points[corner == 0 ? points.size() - 1 : corner - 1];
  const Point after = points[corner + 1 == points.size() ? 0 : corner + 1];
  const Point v = points[corner];
  return 0.5 * v + 0.5 * opposite_of(points, before, v, after);
}

}  // namespace mapwright::validators
