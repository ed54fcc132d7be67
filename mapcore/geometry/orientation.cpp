#include "mapcore/geometry/orientation.hpp"

#include <cfloat>
#include <cmath>

#include "mapcore/geometry/exact_arithmetic.hpp"
#include "mapcore/geometry/filtered_turn.hpp"

namespace mapwright {
namespace {

constexpr double kRounding = DBL_EPSILON / 2.0;

constexpr int sign(double value) {
  return value > 0.0 ? 1 : (value < 0.0 ? -1 : 0);
}

// Sign of u1 * v1 - u2 * v2 where one of the products is zero: no rounding can spoil it.
constexpr int sign_with_zero_product(double u1, double v1, double u2, double v2) {
  return u1 == 0.0 || v1 == 0.0 ? -sign(u2) * sign(v2) : sign(u1) * sign(v1);
}

// Twice the signed area as seen from the first vertex, and the sum of the absolute products.
struct AreaSum {
  double twice_area = 0.0;
  double magnitude = 0.0;
};

AreaSum area_sum(std::span<const Point> ring) {
  AreaSum sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point u = ring[i] - ring[0];
    const Point v = ring[i + 1] - ring[0];
    sum.twice_area += u.x * v.y - u.y * v.x;
    sum.magnitude += std::abs(u.x * v.y) + std::abs(u.y * v.x);
  }
  return sum;
}

// True if the edge ab separates p from the point infinitely far to the right of it.
bool is_crossed_by_ray(Point a, Point b, Point p) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  const Turn side = turn(a, b, p);
  return b.y > a.y ? side == Turn::kLeft : side == Turn::kRight;
}

bool is_on_edge(Point a, Point b, Point p) {
  Box box = kEmptyBox;
  box.add(a);
  box.add(b);
  return box.contains(p) && turn(a, b, p) == Turn::kStraight;
}

}  // namespace

Turn turn(Point a, Point b, Point p) {
  const Point u = b - a;
  const Point v = p - a;
  if (u.x == 0.0 || u.y == 0.0 || v.x == 0.0 || v.y == 0.0) {
    if (std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(v.x) && std::isfinite(v.y)) {
      return static_cast<Turn>(sign_with_zero_product(u.x, v.y, u.y, v.x));
    }
  }
  const int sure = sure_sign_of_cross(u, v);
  return sure != 0 ? static_cast<Turn>(sure) : exact::turn(a, b, p);
}

RingOrientation ring_orientation(std::span<const Point> ring) {
  if (ring.size() < 3) return RingOrientation::kDegenerate;
  const AreaSum sum = area_sum(ring);
  const double error = (3.0 * static_cast<double>(ring.size()) + 8.0) * kRounding * sum.magnitude;
  if (in_safe_range(sum.magnitude) && std::abs(sum.twice_area) > error) {
    return static_cast<RingOrientation>(sign(sum.twice_area));
  }
  return static_cast<RingOrientation>(exact::area_sign(ring));
}

double signed_area_m2(std::span<const Point> ring) {
  return 0.5 * area_sum(ring).twice_area;
}

PointSide side_of_ring(std::span<const Point> ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (is_on_edge(a, b, p)) return PointSide::kBoundary;
    if (is_crossed_by_ray(a, b, p)) inside = !inside;
  }
  return inside ? PointSide::kInside : PointSide::kOutside;
}

}  // namespace mapwright
