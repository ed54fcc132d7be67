#include "mapcore/geometry/bounding_circle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapwright {
namespace {

// Up to three points on the circle, which alone determine it.
struct Support {
  std::array<Point, 3> points{};
  std::size_t size = 0;
};

struct Candidate {
  Point center;
  double squared_radius = HUGE_VAL;
  Support support;
};

Point middle(Point p, Point q) {
  return 0.5 * p + 0.5 * q;
}

double squared_distance(Point p, Point q) {
  return squared_length(q - p);
}

// Centre of the circle through three points. Seen from an end of the shortest edge, which keeps the
// digits of needles; not finite for points on one line.
Point circumcenter(Point p, Point q, Point r) {
  const double qr = squared_distance(q, r);
  if (qr < squared_distance(p, q) && qr < squared_distance(r, p)) std::swap(p, r);
  const Point u = q - p, v = r - p;
  const double uu = squared_length(u), vv = squared_length(v);
  const double scale = 0.5 / cross(u, v);
  return p + scale * Point{uu * v.y - vv * u.y, vv * u.x - uu * v.x};
}

// The radius is the one that really covers the points, so bad centres lose by themselves.
void offer(Candidate& best, Point center, const Support& support, std::span<const Point> points) {
  double squared_radius = 0.0;
  for (const Point p : points) {
    const double d = squared_distance(center, p);
    if (!(d <= squared_radius)) squared_radius = d;
  }
  if (squared_radius < best.squared_radius) best = {center, squared_radius, support};
}

// Smallest circle around at most four points of which `newest` lies on it.
Candidate circle_of_few(const Support& old, Point newest) {
  std::array<Point, 4> points{newest};
  std::copy_n(old.points.begin(), old.size, points.begin() + 1);
  const std::span<const Point> all(points.data(), old.size + 1);
  Candidate best;
  for (std::size_t i = 1; i < all.size(); ++i) {
    offer(best, middle(newest, all[i]), {{newest, all[i]}, 2}, all);
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      offer(best, circumcenter(newest, all[i], all[j]), {{newest, all[i], all[j]}, 3}, all);
    }
  }
  return best;
}

Point farthest_from(Point center, std::span<const Point> points) {
  Point farthest = points.front();
  double largest = -1.0;
  for (const Point p : points) {
    const double d = squared_distance(center, p);
    if (d > largest) {
      largest = d;
      farthest = p;
    }
  }
  return farthest;
}

double covering_radius(Point center, std::span<const Point> points) {
  double radius = 0.0;
  for (const Point p : points) radius = std::max(radius, distance(center, p));
  return radius;
}

}  // namespace

// The farthest point enters, the circle around it and the old support grows, until nobody is
// outside (Gärtner, Fast and Robust Smallest Enclosing Balls, 1999). The radius grows with each
// round, so the rounds end; where rounding stops the growth, the last centre is kept.
Circle min_bounding_circle(std::span<const Point> points) {
  if (points.empty()) return {{}, -1.0};
  Candidate circle{points.front(), 0.0, {{points.front()}, 1}};
  while (true) {
    const Point farthest = farthest_from(circle.center, points);
    if (squared_distance(circle.center, farthest) <= circle.squared_radius) break;
    const Candidate larger = circle_of_few(circle.support, farthest);
    if (!(larger.squared_radius > circle.squared_radius)) break;
    circle = larger;
  }
  return {circle.center, covering_radius(circle.center, points)};
}

Circle min_bounding_circle(const Obstacle& obstacle) {
  std::vector<Point> points;
  points.reserve(2 * obstacle.segments.size());
  for (const auto& segment : obstacle.segments) {
    if (points.empty() || points.back() != segment.a) points.push_back(segment.a);
    points.push_back(segment.b);
  }
  return min_bounding_circle(points);
}

}  // namespace mapwright
