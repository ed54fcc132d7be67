// Discs: paths that keep their distance, and how much the offset costs.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "navcore/exact/exact_planner.hpp"
#include "navcore/exact/path_check.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

ExactPlanner planner_of(const Map& map, const ExactOptions& options) {
  auto planner = ExactPlanner::build(map, options);
  EXPECT_TRUE(planner.has_value()) << planner.error().message;
  return std::move(*planner);
}

TEST(DiscPlanner, GoesAroundACornerInACircle) {
  Map map{{-1, 10, 11, 0}, {}};
  map.obstacles.push_back(test::wall(1, {5, 0}, {5, 5}, 1.0));
  // Tangents from (1, 5) and (9, 5) to the circle of radius 1 around (5, 5).
  const double tangent_m = std::sqrt(15.0);
  const double exact_m = 2.0 * tangent_m + 2.0 * std::asin(1.0 / 4.0);
  const auto coarse = planner_of(map, {.radius_m = 1.0}).plan({1, 5}, {9, 5});
  const auto fine =
      planner_of(map, {.radius_m = 1.0, .tangents_a_quadrant = 32}).plan({1, 5}, {9, 5});
  EXPECT_GE(fine.length_m, exact_m);
  EXPECT_NEAR(fine.length_m, exact_m, 0.002);
  EXPECT_GE(coarse.length_m, fine.length_m - 0.002);
  EXPECT_NEAR(coarse.length_m, exact_m, 0.05);
}

TEST(DiscPlanner, DecidesGapsExactly) {
  Map map{{0, 10, 10, 0}, {}};
  map.obstacles.push_back(test::wall(1, {5, 0}, {5, 4.5}, 1.0));
  map.obstacles.push_back(test::wall(2, {5, 5.5}, {5, 10}, 1.0));
  const auto reachable = [&](double radius_m) {
    return planner_of(map, {.radius_m = radius_m}).plan({2, 2}, {8, 8});
  };
  EXPECT_EQ(reachable(0.495).verdict, Verdict::kReachable);  // coarse tangents refuse
  const auto tight = reachable(0.5);                         // touches both ends
  EXPECT_EQ(tight.verdict, Verdict::kReachable);
  EXPECT_TRUE(
      is_path_clear(map.border, blocking_segments(map, RampPolicy::kFree), tight.path, 0.5));
  EXPECT_NEAR(tight.length_m, 8.5, 0.1);
  const auto blocked = reachable(0.500001);
  EXPECT_EQ(blocked.verdict, Verdict::kUnreachable);
  ASSERT_FALSE(blocked.barrier.empty());
  const auto gap = std::find_if(blocked.barrier.begin(), blocked.barrier.end(),
                                [](const BarrierSide& side) { return side.is_gap; });
  ASSERT_NE(gap, blocked.barrier.end());
  EXPECT_NEAR(distance(gap->from, gap->to), 1.0, 1e-9);
}

// Convex obstacles grown by the test itself: by a polygon within the disc, and by one around it.
Obstacle grown(const Obstacle& solid, double radius_m) {
  constexpr int kSides = 128;
  std::vector<Point> cloud;
  for (const auto& segment : solid.segments) {
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kSides;
      cloud.push_back(segment.a + radius_m * Point{std::cos(angle), std::sin(angle)});
    }
  }
  std::sort(cloud.begin(), cloud.end(),
            [](Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  std::vector<Point> hull;
  const auto extend = [&](Point p, std::size_t keep) {
    while (hull.size() >= keep + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point p : cloud) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = cloud.rbegin() + 1; p != cloud.rend(); ++p) extend(*p, lower);
  hull.pop_back();
  return test::outline(solid.id, hull, 1.0);
}

Map grown(const Map& map, double radius_m) {
  Map result{{map.border.left + radius_m, map.border.top - radius_m, map.border.right - radius_m,
              map.border.bottom + radius_m},
             {}};
  for (const auto& obstacle : map.obstacles) {
    result.obstacles.push_back(grown(obstacle, radius_m));
  }
  return result;
}

Map boxes(Random& random) {
  Map map{{0.0, test::kSide_m, test::kSide_m, 0.0}, {}};
  for (int i = 0; i < 9; ++i) {
    const Obstacle obstacle = test::whole_box(i + 1, random);
    if (test::has_area(obstacle)) map.obstacles.push_back(obstacle);
  }
  return map;
}

// A disc's path lies between the point's paths among obstacles grown a little less and more.
TEST(DiscPlanner, IsAsLongAsAPathAmongGrownObstacles) {
  Random random(11);
  int solved = 0, refused = 0;
  for (int round = 0; round < 1000; ++round) {
    const Map map = boxes(random);
    const double radius_m = 0.1 + 0.6 * random.uniform();
    const auto planner = planner_of(map, {.radius_m = radius_m, .tangents_a_quadrant = 32});
    const auto least = planner_of(grown(map, radius_m - 0.002), {});
    const auto most = planner_of(grown(map, radius_m * 1.001 + 0.006), {});
    const auto segments = blocking_segments(map, RampPolicy::kFree);
    for (int i = 0; i < 5; ++i) {
      const Point a{random.uniform(0, 20), random.uniform(0, 20)};
      const Point b{random.uniform(0, 20), random.uniform(0, 20)};
      const auto answer = planner.plan(a, b), low = least.plan(a, b), high = most.plan(a, b);
      ASSERT_TRUE(high.path.empty() || !answer.path.empty()) << round;
      if (answer.path.empty()) {
        ++refused;
        continue;
      }
      ++solved;
      ASSERT_TRUE(is_path_clear(map.border, segments, answer.path, radius_m)) << round;
      ASSERT_FALSE(low.path.empty()) << round;
      ASSERT_GE(answer.length_m, low.length_m - 0.003) << round;
      ASSERT_TRUE(high.path.empty() || answer.length_m <= high.length_m + 0.003) << round;
    }
  }
  EXPECT_GT(solved, 200);
  EXPECT_GT(refused, 20);
}

// Walls, stairs, notches, overlaps: every path keeps its distance from every raw segment.
TEST(DiscPlanner, KeepsItsDistanceAmongClutter) {
  Random random(12);
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Map map = test::cluttered_square(seed);
    const auto segments = blocking_segments(map, RampPolicy::kFree);
    for (const double radius_m : {0.05, 0.3, 1.0}) {
      const auto planner = planner_of(map, {.radius_m = radius_m});
      for (int i = 0; i < 20; ++i) {
        const Point a{random.uniform(0, 60), random.uniform(0, 60)};
        const Point b{random.uniform(0, 60), random.uniform(0, 60)};
        const auto answer = planner.plan(a, b);
        if (answer.path.empty()) continue;
        ++solved;
        ASSERT_TRUE(is_path_clear(map.border, segments, answer.path, radius_m))
            << seed << " " << radius_m;
      }
    }
  }
  EXPECT_GT(solved, 200);
}

}  // namespace
}  // namespace mapwright::navcore
