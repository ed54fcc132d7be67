#include "mapcore/geometry/orientation.hpp"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/mapcore/geometry/generators.hpp"

namespace mapwright {
namespace {

using Rational = CGAL::Exact_rational;

Rational exact_cross(Point a, Point b, Point p) {
  return (Rational(b.x) - a.x) * (Rational(p.y) - a.y) -
         (Rational(b.y) - a.y) * (Rational(p.x) - a.x);
}

int exact_turn(Point a, Point b, Point p) {
  return CGAL::sign(exact_cross(a, b, p));
}

TEST(Turn, EqualsRationalArithmetic) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const auto p = test::random_points(random, 3);
    ASSERT_EQ(static_cast<int>(turn(p[0], p[1], p[2])), exact_turn(p[0], p[1], p[2]));
  }
}

TEST(Turn, IsExactWhereProductsUnderflowOrOverflow) {
  EXPECT_EQ(turn({0, 0}, {1e-200, 1e-200}, {1e-200, 2e-200}), Turn::kLeft);
  EXPECT_EQ(turn({0, 0}, {1e-200, 1e-200}, {2e-200, 2e-200}), Turn::kStraight);
  EXPECT_EQ(turn({0, 0}, {1e200, 1e200}, {2e200, 1e200}), Turn::kRight);
  EXPECT_EQ(turn({-1e308, 0}, {1e308, 0}, {0, 5e-324}), Turn::kLeft);
}

TEST(RingOrientation, IsTheSignOfTheArea) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(ring_orientation(square), RingOrientation::kCounterClockwise);
  EXPECT_EQ(ring_orientation(std::vector<Point>(square.rbegin(), square.rend())),
            RingOrientation::kClockwise);
  EXPECT_EQ(ring_orientation(std::vector<Point>{{0, 0}, {1, 0}, {2, 0}}),
            RingOrientation::kDegenerate);
  EXPECT_EQ(ring_orientation(std::vector<Point>{{0, 0}, {1, 0}}), RingOrientation::kDegenerate);
  EXPECT_DOUBLE_EQ(signed_area_m2(square), 1.0);
}

TEST(RingOrientation, EqualsRationalArithmetic) {
  Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    const auto ring = test::random_points(random, 3 + random.below(7));
    Rational area = 0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      area += exact_cross(ring[0], ring[k], ring[k + 1]);
    }
    ASSERT_EQ(static_cast<int>(ring_orientation(ring)), static_cast<int>(CGAL::sign(area)));
  }
}

TEST(SideOfRing, KnowsInsideBoundaryAndOutside) {
  const std::vector<Point> notched{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}};
  EXPECT_EQ(side_of_ring(notched, {1, 1}), PointSide::kInside);
  EXPECT_EQ(side_of_ring(notched, {3, 3}), PointSide::kBoundary);
  EXPECT_EQ(side_of_ring(notched, {2, 2}), PointSide::kBoundary);
  EXPECT_EQ(side_of_ring(notched, {2, 0}), PointSide::kBoundary);
  EXPECT_EQ(side_of_ring(notched, {2, 2.5}), PointSide::kOutside);
  EXPECT_EQ(side_of_ring(notched, {-1, 0}), PointSide::kOutside);
  EXPECT_EQ(side_of_ring(notched, {1, std::nextafter(3.0, 4.0)}), PointSide::kOutside);
}

TEST(SideOfRing, AgreesForBothOrientationsAndAnyFirstVertex) {
  Random random(3);
  for (int i = 0; i < 5'000; ++i) {
    auto ring = test::random_points(random, 3 + random.below(9));
    const Point p = i % 2 == 0 ? ring[0] : 0.5 * ring[0] + 0.5 * ring[1];
    const Point q = 0.25 * ring[0] + 0.75 * ring[2];
    const auto side_p = side_of_ring(ring, p);
    const auto side_q = side_of_ring(ring, q);
    if (i % 2 == 0) {
      ASSERT_EQ(side_p, PointSide::kBoundary);
    }
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    std::reverse(ring.begin(), ring.end());
    ASSERT_EQ(side_of_ring(ring, p), side_p);
    ASSERT_EQ(side_of_ring(ring, q), side_q);
  }
}

}  // namespace
}  // namespace mapwright
