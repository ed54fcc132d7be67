// A point of the map's plane.
#pragma once

#include <cmath>

namespace mapwright {

/// A point, or a difference of two points: metres, map frame (x to the right, y up).
struct Point {
  double x = 0.0;
  double y = 0.0;

  friend bool operator==(const Point&, const Point&) = default;
};

constexpr Point operator+(Point p, Point q) { return {p.x + q.x, p.y + q.y}; }
constexpr Point operator-(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
constexpr Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }

constexpr double dot(Point p, Point q) { return p.x * q.x + p.y * q.y; }

/// z component of p × q: twice the signed area of the triangle 0, p, q.
constexpr double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }

constexpr double squared_length(Point p) { return dot(p, p); }
inline double length(Point p) { return std::hypot(p.x, p.y); }
inline double distance(Point p, Point q) { return length(q - p); }
inline bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Foot of the perpendicular from `p` on the closed segment ab (an end where the foot is beyond it).
constexpr Point closest_point_on_segment(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double denominator = squared_length(ab);
  if (denominator == 0.0) return a;
  const double t = dot(p - a, ab) / denominator;
  if (t <= 0.0) return a;
  if (t >= 1.0) return b;
  return a + t * ab;
}

/// An axis-parallel box, closed. `kEmptyBox` grows to hold whatever is added to it.
struct Box {
  double min_x, min_y, max_x, max_y;

  constexpr void add(Point p) {
    if (p.x < min_x) min_x = p.x;
    if (p.y < min_y) min_y = p.y;
    if (p.x > max_x) max_x = p.x;
    if (p.y > max_y) max_y = p.y;
  }
  constexpr bool is_empty() const { return !(min_x <= max_x && min_y <= max_y); }
  constexpr bool contains(Point p) const {
    return min_x <= p.x && p.x <= max_x && min_y <= p.y && p.y <= max_y;
  }
  constexpr double width() const { return max_x - min_x; }
  constexpr double height() const { return max_y - min_y; }
  constexpr Box inflated(double by_m) const {
    return {min_x - by_m, min_y - by_m, max_x + by_m, max_y + by_m};
  }

  friend bool operator==(const Box&, const Box&) = default;
};

inline constexpr Box kEmptyBox{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

}  // namespace mapwright
