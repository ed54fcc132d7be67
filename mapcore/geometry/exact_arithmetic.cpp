#include "mapcore/geometry/exact_arithmetic.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <cassert>
#include <vector>

namespace mapwright::exact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rational = CGAL::Exact_rational;

Kernel::Point_2 to_cgal(Point p) {
  return {p.x, p.y};
}

struct RationalVector {
  Rational x, y;
};

RationalVector difference(Point p, Point q) {
  return {Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y)};
}

Rational cross(const RationalVector& u, const RationalVector& v) {
  return u.x * v.y - u.y * v.x;
}

}  // namespace

Turn turn(Point a, Point b, Point p) {
  // Points of chains are often the same one: no filter can tell a zero, so they would cost most.
  if (a == b || b == p || p == a) return Turn::kStraight;
  return static_cast<Turn>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(p)));
}

int area_sign(std::span<const Point> ring) {
  Rational twice_area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = ring[i];
    const Point q = ring[i + 1 == ring.size() ? 0 : i + 1];
    twice_area += cross(difference(ring[0], p), difference(ring[0], q));
  }
  return static_cast<int>(CGAL::sign(twice_area));
}

Point crossing(Point a, Point b, Point c, Point d) {
  const RationalVector ab = difference(a, b);
  const RationalVector cd = difference(c, d);
  const Rational denominator = cross(ab, cd);
  assert(denominator != 0);
  const Rational t = cross(difference(a, c), cd) / denominator;
  return {CGAL::to_double(Rational(a.x) + t * ab.x), CGAL::to_double(Rational(a.y) + t * ab.y)};
}

bool is_simple(std::span<const Point> ring) {
  std::vector<Kernel::Point_2> points;
  points.reserve(ring.size());
  for (const Point p : ring) points.push_back(to_cgal(p));
  return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

}  // namespace mapwright::exact
