#include "converter/source/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mapwright::converter {
namespace {

TEST(Arc, KeepsChordsWithinTheSagitta) {
  const Point center{3.0, -2.0};
  for (const double radius : {0.05, 1.0, 40.0, 5000.0}) {
    const auto at = [&](double angle) {
      return center + radius * Point{std::cos(angle), std::sin(angle)};
    };
    std::vector<Point> points{at(0.3)};
    append_arc(at(0.3), at(1.9), at(4.1), 0.01, points);
    EXPECT_EQ(points.back(), at(4.1));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      EXPECT_NEAR(distance(points[i], center), radius, 1e-9 * radius);
      const double middle = distance(0.5 * (points[i] + points[i + 1]), center);
      EXPECT_LE(radius - middle, 0.01 + 1e-9);
    }
  }
}

TEST(Arc, GivesTheSamePointsBackwards) {
  std::vector<Point> forward{{0, 0}};
  append_arc({0, 0}, {5, 3}, {10, 0}, 0.01, forward);
  std::vector<Point> backward{{10, 0}};
  append_arc({10, 0}, {5, 3}, {0, 0}, 0.01, backward);
  ASSERT_EQ(forward.size(), backward.size());
  for (std::size_t i = 0; i < forward.size(); ++i) {
    EXPECT_LT(distance(forward[i], backward[forward.size() - 1 - i]), 1e-12);
  }
}

TEST(Arc, IsAFullCircleWhereItEndsWhereItBegan) {
  std::vector<Point> points{{0, 0}};
  append_arc({0, 0}, {2, 0}, {0, 0}, 0.01, points);
  EXPECT_EQ(points.back(), (Point{0, 0}));
  EXPECT_GT(points.size(), 10U);
  for (const Point p : points) EXPECT_NEAR(distance(p, {1, 0}), 1.0, 1e-12);
}

TEST(Arc, IsALineWhereThePointsAre) {
  std::vector<Point> points{{0, 0}};
  append_arc({0, 0}, {1, 1}, {2, 2}, 0.01, points);
  EXPECT_EQ(points, (std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}));
}

}  // namespace
}  // namespace mapwright::converter
