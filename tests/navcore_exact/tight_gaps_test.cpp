// Gaps into which the disc fits to the millimetre, and less: decided all the same.
#include <gtest/gtest.h>

#include <cmath>

#include "navcore/exact/barrier_proof.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "navcore/exact/path_check.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

ExactPlanner planner_of(const Map& map, double radius_m) {
  auto planner = ExactPlanner::build(map, {.radius_m = radius_m});
  EXPECT_TRUE(planner.has_value()) << planner.error().message;
  return std::move(*planner);
}

// The path of a disc that fits, checked against the map's segments; and the barrier of one that is
// a micrometre wider, checked as well.
ExactAnswer passes_exactly(const Map& map, double radius_m, Point start, Point goal) {
  const auto answer = planner_of(map, radius_m).plan(start, goal);
  EXPECT_EQ(answer.verdict, Verdict::kReachable);
  EXPECT_FALSE(answer.path.empty());
  const auto segments = blocking_segments(map, RampPolicy::kFree);
  EXPECT_TRUE(is_path_clear(map.border, segments, answer.path, radius_m));
  const double wider_m = radius_m + 1e-6;
  const auto refused = planner_of(map, wider_m).plan(start, goal);
  EXPECT_EQ(refused.verdict, Verdict::kUnreachable);
  EXPECT_TRUE(proves_unreachable(map, RampPolicy::kFree, refused.barrier, start, goal, wider_m));
  return answer;
}

TEST(TightGap, IsALeakInABox) {
  Map map{{0, 10, 10, 0}, {}};
  // Its right side is two walls with a gap between them.
  map.obstacles.push_back(test::outline(1, {{3, 3}, {7, 3}, {7, 7}, {3, 7}}, 1.0));
  map.obstacles[0].segments.erase(map.obstacles[0].segments.begin() + 1);
  map.obstacles.push_back(test::wall(2, {7, 3}, {7, 4.5}, 1.0));
  map.obstacles.push_back(test::wall(3, {7, 5}, {7, 7}, 1.0));
  const auto answer = passes_exactly(map, 0.25, {5, 6}, {1, 5});
  EXPECT_LT(answer.length_m, 12.0);
}

TEST(TightGap, TwoInARowWithABendBetween) {
  Map map{{0, 10, 10, 0}, {}};
  map.obstacles.push_back(test::wall(1, {5, 0}, {5, 4.5}, 1.0));
  map.obstacles.push_back(test::wall(2, {5, 5.5}, {5, 10}, 1.0));
  map.obstacles.push_back(test::wall(3, {6.1, 0}, {6.1, 5.5}, 1.0));
  map.obstacles.push_back(test::wall(4, {6.1, 6.5}, {6.1, 10}, 1.0));
  const auto answer = passes_exactly(map, 0.5, {2, 2}, {8, 8});
  EXPECT_NEAR(answer.length_m, 8.7, 0.3);
}

TEST(TightGap, IsACorridorThatBendsTwice) {
  Map map{{0, 10, 10, 0}, {}};
  // 0.8 m wide: along x, then along y, then along x again.
  map.obstacles.push_back(test::outline(1, {{2, 0}, {8, 0}, {8, 6}, {5, 6}, {5, 3}, {2, 3}}, 1.0));
  map.obstacles.push_back(
      test::outline(2, {{2, 3.8}, {4.2, 3.8}, {4.2, 6.8}, {8, 6.8}, {8, 10}, {2, 10}}, 1.0));
  const auto answer = passes_exactly(map, 0.4, {1, 3.4}, {9, 6.4});
  EXPECT_NEAR(answer.length_m, 11.0, 0.5);
}

TEST(TightGap, IsASlantedCorridorAfterADoor) {
  Map map{{0, 20, 20, 0}, {}};
  map.obstacles.push_back(test::wall(1, {5, 0}, {5, 9.5}, 1.0));
  map.obstacles.push_back(test::wall(2, {5, 10.5}, {5, 20}, 1.0));
  map.obstacles.push_back(test::wall(3, {5.6, 10.8}, {9.6, 13.8}, 1.0));
  map.obstacles.push_back(test::wall(4, {6.2, 10}, {10.2, 13}, 1.0));
  passes_exactly(map, 0.5, {2, 2}, {15, 15});
}

// Rooms A, B, C, D in a row: A-B and C-D are passed exactly, B-C is a micrometre too narrow. Every
// barrier between A and D has to go around two rooms at least.
TEST(TightGap, LiesBesideTheBarrier) {
  Map map{{0, 10, 40, 0}, {}};
  const auto add_door = [&](double x_m, double width_m) {
    const auto id = static_cast<std::int64_t>(map.obstacles.size()) + 1;
    map.obstacles.push_back(test::wall(id, {x_m, 0}, {x_m, 4}, 1.0));
    map.obstacles.push_back(test::wall(id + 1, {x_m, 4 + width_m}, {x_m, 10}, 1.0));
  };
  add_door(10, 1.0), add_door(20, 0.999), add_door(30, 1.0);
  const Point start{5, 5}, goal{35, 5};
  const auto answer = planner_of(map, 0.5).plan(start, goal);
  EXPECT_EQ(answer.verdict, Verdict::kUnreachable);
  EXPECT_TRUE(proves_unreachable(map, RampPolicy::kFree, answer.barrier, start, goal, 0.5));
}

TEST(TightGap, IsDecidedWhereverADiscGetsStuck) {
  Random random(31);
  int exact = 0;
  for (int round = 0; round < 500; ++round) {
    const Map map = test::crowded_map(random);
    const auto point = planner_of(map, 0.0);
    for (int i = 0; i < 4; ++i) {
      const Point a{random.uniform(0, 20), random.uniform(0, 20)};
      const Point b{random.uniform(0, 20), random.uniform(0, 20)};
      const auto narrow = point.bottleneck(a, b);
      if (!narrow || narrow->is_end || narrow->width_m < 0.02) continue;
      const auto planner = point.with_radius(0.5 * narrow->width_m);
      ASSERT_TRUE(planner.has_value());
      if (planner->state(a) != PlaceState::kFree || planner->state(b) != PlaceState::kFree)
        continue;
      ++exact;
      SCOPED_TRACE("round " + std::to_string(round) + "." + std::to_string(i));
      passes_exactly(map, 0.5 * narrow->width_m, a, b);
    }
  }
  EXPECT_GT(exact, 100);
}

}  // namespace
}  // namespace mapwright::navcore
