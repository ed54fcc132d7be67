#include "mapcore/geometry/bounding_circle.hpp"

#include <CGAL/Exact_rational.h>
#include <CGAL/Min_circle_2.h>
#include <CGAL/Min_circle_2_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "tests/mapcore/geometry/generators.hpp"

namespace mapwright {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using ExactCircle = CGAL::Min_circle_2<CGAL::Min_circle_2_traits_2<Kernel>>;

// The centre is a double: what it loses to rounding, the radius must gain.
constexpr double kRounding_m = 1e-12;

double exact_radius(const std::vector<Point>& points) {
  std::vector<Kernel::Point_2> exact;
  for (const Point p : points) exact.emplace_back(p.x, p.y);
  const ExactCircle circle(exact.begin(), exact.end(), true);
  return std::sqrt(CGAL::to_double(circle.circle().squared_radius()));
}

void expect_contains(const Circle& circle, const std::vector<Point>& points) {
  for (const Point p : points) ASSERT_LE(distance(circle.center, p), circle.radius_m);
}

TEST(BoundingCircle, OfFewPoints) {
  EXPECT_LT(min_bounding_circle(std::vector<Point>{}).radius_m, 0.0);
  const auto one = min_bounding_circle(std::vector<Point>{{3, 4}});
  EXPECT_EQ(one.center, (Point{3, 4}));
  EXPECT_EQ(one.radius_m, 0.0);
  const auto two = min_bounding_circle(std::vector<Point>{{0, 0}, {6, 8}});
  EXPECT_EQ(two.center, (Point{3, 4}));
  EXPECT_EQ(two.radius_m, 5.0);
  EXPECT_EQ(min_bounding_circle(std::vector<Point>{{1, 1}, {1, 1}, {1, 1}}).radius_m, 0.0);
}

TEST(BoundingCircle, OfTheReportsColumn) {
  Obstacle column;
  column.segments = {{{4.53, 12.10}, {7.29, 12.10}, 5.0, InOut::kOutdoor, {}},
                     {{7.29, 12.10}, {7.29, 13.86}, 5.0, InOut::kOutdoor, {}},
                     {{7.29, 13.86}, {4.53, 13.86}, 5.0, InOut::kOutdoor, {}},
                     {{4.53, 13.86}, {4.53, 12.10}, 5.0, InOut::kOutdoor, {}}};
  const auto circle = min_bounding_circle(column);
  EXPECT_NEAR(circle.center.x, 5.91, 1e-12);
  EXPECT_NEAR(circle.center.y, 12.98, 1e-12);
  EXPECT_NEAR(circle.radius_m, 0.5 * std::hypot(2.76, 1.76), 1e-12);
}

TEST(BoundingCircle, HoldsAllPointsAndIsTheSmallest) {
  Random random(9);
  for (int i = 0; i < 5'000; ++i) {
    const auto points = test::random_points(random, 1 + random.below(20));
    const auto circle = min_bounding_circle(points);
    expect_contains(circle, points);
    const double smallest = exact_radius(points);
    ASSERT_NEAR(circle.radius_m, smallest, 1e-9 * smallest + kRounding_m) << i;
  }
}

TEST(BoundingCircle, OfNeedlesAndOfPointsOnACircle) {
  Random random(10);
  for (int i = 0; i < 2'000; ++i) {
    std::vector<Point> points;
    const double thickness = std::pow(10.0, random.uniform(-12.0, 0.0));
    for (int k = 0; k < 12; ++k) {
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      points.push_back({1000.0 + 7.0 * std::cos(angle), 500.0 + thickness * std::sin(angle)});
    }
    const auto circle = min_bounding_circle(points);
    expect_contains(circle, points);
    const double smallest = exact_radius(points);
    ASSERT_NEAR(circle.radius_m, smallest, 1e-9 * smallest + kRounding_m) << i;
  }
}

TEST(BoundingCircle, EndsOnHugeAndTinyNumbers) {
  for (const double scale : {1e-310, 1e-200, 1e150, 1e300}) {
    const std::vector<Point> points{{0, 0}, {scale, 0}, {0.3 * scale, scale}, {scale, scale}};
    expect_contains(min_bounding_circle(points), points);
  }
}

}  // namespace
}  // namespace mapwright
