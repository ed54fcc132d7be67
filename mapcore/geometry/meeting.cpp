#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <tuple>

#include "mapcore/geometry/exact_arithmetic.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright {
namespace {

// Error of the crossing's parameter along the first segment up to which doubles are good enough.
constexpr double kParameterError = 1e-13;

bool lexicographically_less(Point p, Point q) {
  return std::tie(p.x, p.y) < std::tie(q.x, q.y);
}

Point middle(Point p, Point q) {
  return 0.5 * p + 0.5 * q;
}

bool in_box_of(Point a, Point b, Point p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

// Segments on one line, or points: along a line, lexicographic order is order along the line.
SegmentMeeting meet_collinear(Point a, Point b, Point c, Point d) {
  if (lexicographically_less(b, a)) std::swap(a, b);
  if (lexicographically_less(d, c)) std::swap(c, d);
  const Point from = lexicographically_less(a, c) ? c : a;
  const Point to = lexicographically_less(b, d) ? b : d;
  if (lexicographically_less(to, from)) return {};
  if (from == to) return {Meeting::kTouch, from};
  return {Meeting::kOverlap, middle(from, to)};
}

// Rounding may push a computed crossing out of the segments' boxes by an ulp.
Point clamped(Point p, Point a, Point b) {
  return {std::clamp(p.x, std::min(a.x, b.x), std::max(a.x, b.x)),
          std::clamp(p.y, std::min(a.y, b.y), std::max(a.y, b.y))};
}

double magnitude(Point u, Point v) {
  return std::abs(u.x * v.y) + std::abs(u.y * v.x);
}

Point crossing(Point a, Point b, Point c, Point d) {
  const Point ab = b - a, cd = d - c, ac = c - a;
  const double denominator = cross(ab, cd);
  const double error = 4.0 * DBL_EPSILON * (magnitude(ac, cd) + magnitude(ab, cd));
  if (error < kParameterError * std::abs(denominator)) {
    return clamped(a + (cross(ac, cd) / denominator) * ab, a, b);
  }
  return exact::crossing(a, b, c, d);
}

constexpr bool opposite(Turn s, Turn t) {
  return static_cast<int>(s) * static_cast<int>(t) < 0;
}

SegmentMeeting touch_if(bool touches, Point at) {
  return touches ? SegmentMeeting{Meeting::kTouch, at} : SegmentMeeting{};
}

SegmentMeeting point_meets(Point p, Point c, Point d) {
  return touch_if(in_box_of(c, d, p) && turn(c, d, p) == Turn::kStraight, p);
}

}  // namespace

SegmentMeeting meet(Point a, Point b, Point c, Point d) {
  if (a == b) return point_meets(a, c, d);
  if (c == d) return point_meets(c, a, b);
  const Turn side_of_c = turn(a, b, c);
  const Turn side_of_d = turn(a, b, d);
  if (side_of_c == side_of_d) {
    return side_of_c == Turn::kStraight ? meet_collinear(a, b, c, d) : SegmentMeeting{};
  }
  const Turn side_of_a = turn(c, d, a);
  const Turn side_of_b = turn(c, d, b);
  if (opposite(side_of_c, side_of_d) && opposite(side_of_a, side_of_b)) {
    return {Meeting::kCross, crossing(a, b, c, d)};
  }
  if (side_of_c == Turn::kStraight) return touch_if(in_box_of(a, b, c), c);
  if (side_of_d == Turn::kStraight) return touch_if(in_box_of(a, b, d), d);
  if (side_of_a == Turn::kStraight) return touch_if(in_box_of(c, d, a), a);
  if (side_of_b == Turn::kStraight) return touch_if(in_box_of(c, d, b), b);
  return {};
}

}  // namespace mapwright
