#include "navcore/exact/exact_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "navcore/exact/path_check.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

Map empty_map() {
  return {{0.0, 10.0, 10.0, 0.0}, {}};
}

ExactPlanner planner_of(const Map& map, const ExactOptions& options = {}) {
  auto planner = ExactPlanner::build(map, options);
  EXPECT_TRUE(planner.has_value()) << planner.error().message;
  return std::move(*planner);
}

TEST(ExactPlanner, GoesStraightWhereNothingIsInTheWay) {
  const auto answer = planner_of(empty_map()).plan({1, 1}, {4, 5});
  EXPECT_EQ(answer.verdict, Verdict::kReachable);
  EXPECT_EQ(answer.path, (std::vector<Point>{{1, 1}, {4, 5}}));
  EXPECT_DOUBLE_EQ(answer.length_m, 5.0);
}

TEST(ExactPlanner, GoesAroundABoxByItsCorners) {
  Map map = empty_map();
  map.obstacles.push_back(test::box(1, {4, 0, 6, 7}, 1.0));
  const auto answer = planner_of(map).plan({1, 3}, {9, 3});
  EXPECT_EQ(answer.path, (std::vector<Point>{{1, 3}, {4, 7}, {6, 7}, {9, 3}}));
  EXPECT_DOUBLE_EQ(answer.length_m, 12.0);
}

TEST(ExactPlanner, LeavesAPlaceForItself) {
  const auto answer = planner_of(empty_map()).plan({1, 1}, {1, 1});
  EXPECT_EQ(answer.verdict, Verdict::kReachable);
  EXPECT_EQ(answer.path.size(), 2U);
  EXPECT_EQ(answer.length_m, 0.0);
}

TEST(ExactPlanner, StartsAndEndsOnOutlinesAndRunsAlongThem) {
  Map map = empty_map();
  map.obstacles.push_back(test::box(1, {2, 2, 8, 8}, 1.0));
  const auto answer = planner_of(map).plan({2, 5}, {5, 2});
  EXPECT_EQ(answer.path, (std::vector<Point>{{2, 5}, {2, 2}, {5, 2}}));
}

TEST(ExactPlanner, PassesNoWallWhereTwoOfThemTouch) {
  Map map = empty_map();
  map.obstacles.push_back(test::wall(1, {0, 5}, {5, 5}, 1.0));
  map.obstacles.push_back(test::wall(2, {5, 5}, {10, 5}, 1.0));
  const auto answer = planner_of(map).plan({5, 2}, {5, 8});
  EXPECT_EQ(answer.verdict, Verdict::kUnreachable);
  EXPECT_FALSE(answer.barrier.empty());
}

TEST(ExactPlanner, PassesBothSidesOfAThinWall) {
  Map map = empty_map();
  map.obstacles.push_back(test::wall(1, {5, 0}, {5, 6}, 1.0));
  const auto answer = planner_of(map).plan({4, 3}, {6, 3});
  ASSERT_EQ(answer.path.size(), 3U);
  EXPECT_EQ(answer.path[1], (Point{5, 6}));
}

TEST(ExactPlanner, ToleratesCrossingWallsAndObstaclesBeyondTheBorder) {
  Map map = empty_map();
  map.obstacles.push_back(test::wall(1, {-3, 1}, {7.123, 12}, 1.0));
  map.obstacles.push_back(test::wall(2, {1, 9}, {8.77, -5}, 1.0));
  map.obstacles.push_back(test::box(3, {50, 50, 60, 60}, 1.0));
  const auto planner = planner_of(map);
  EXPECT_EQ(planner.components().size(), 3U);
  EXPECT_LE(planner.snapping_error_m(), 0.002);
  EXPECT_EQ(planner.plan({0.1, 0.1}, {9, 9}).verdict, Verdict::kUnreachable);
}

TEST(ExactPlanner, NamesWhatIsWrongWithAPlace) {
  Map map = empty_map();
  map.obstacles.push_back(test::box(1, {4, 4, 6, 6}, 1.0));
  const auto planner = planner_of(map);
  EXPECT_EQ(planner.state({5, 5}), PlaceState::kBlocked);
  EXPECT_EQ(planner.state({4, 5}), PlaceState::kFree);
  EXPECT_EQ(planner.state({11, 5}), PlaceState::kOutsideBorder);
  EXPECT_EQ(planner.state({std::nan(""), 5}), PlaceState::kNotFinite);
  EXPECT_EQ(planner.state({HUGE_VAL, 5}), PlaceState::kNotFinite);
  const auto answer = planner.plan({5, 5}, {1, std::nan("")});
  EXPECT_EQ(answer.start, PlaceState::kBlocked);
  EXPECT_EQ(answer.goal, PlaceState::kNotFinite);
  EXPECT_TRUE(answer.path.empty());
}

TEST(ExactPlanner, RefusesWhatMakesNoSense) {
  EXPECT_FALSE(ExactPlanner::build(empty_map(), {.radius_m = -0.1}).has_value());
  EXPECT_FALSE(ExactPlanner::build(empty_map(), {.radius_m = std::nan("")}).has_value());
  EXPECT_FALSE(ExactPlanner::build(empty_map(), {.radius_m = HUGE_VAL}).has_value());
  EXPECT_FALSE(ExactPlanner::build(empty_map(), {.tangents_a_quadrant = 0}).has_value());
  EXPECT_FALSE(ExactPlanner::build({{0, 0, 0, 0}, {}}, {}).has_value());
  EXPECT_FALSE(ExactPlanner::build({{0, 10, std::nan(""), 0}, {}}, {}).has_value());
  EXPECT_FALSE(ExactPlanner::build({{0, 1e9, 1e9, 0}, {}}, {}).has_value());
  Map far = empty_map();
  far.obstacles.push_back(test::wall(7, {0, 0}, {1e7, 0}, 1.0));
  const auto failed = ExactPlanner::build(far, {});
  ASSERT_FALSE(failed.has_value());
  EXPECT_NE(failed.error().message.find("obstacle 7"), std::string::npos);
}

TEST(ExactPlanner, FindsNoPlaceForARobotWiderThanTheMap) {
  for (const double radius_m : {5.0, 6.0, 1e9}) {
    const auto planner = planner_of(empty_map(), {.radius_m = radius_m});
    EXPECT_EQ(planner.state({5, 5}), PlaceState::kBlocked) << radius_m;
    EXPECT_TRUE(planner.components().empty()) << radius_m;
  }
  EXPECT_EQ(planner_of(empty_map(), {.radius_m = 4.9}).state({5, 5}), PlaceState::kFree);
}

TEST(ExactPlanner, WorksFarFromTheOriginAndWithNegativeCoordinates) {
  for (const Point shift : {Point{425800, 4582230}, Point{-7000, -9000}}) {
    Map map{{shift.x, shift.y + 10, shift.x + 10, shift.y}, {}};
    map.obstacles.push_back(test::box(1, {shift.x + 4, shift.y, shift.x + 6, shift.y + 7}, 1.0));
    const auto answer = planner_of(map).plan(shift + Point{1, 3}, shift + Point{9, 3});
    EXPECT_NEAR(answer.length_m, 12.0, 1e-8);
  }
}

TEST(ExactPlanner, KnowsRoomsCourtyardsStairsAndRamps) {
  Map map = empty_map();
  map.obstacles.push_back(test::box(1, {1, 1, 9, 9}, 3.0));
  map.obstacles.push_back(test::outline(2, {{2, 2}, {2, 8}, {8, 8}, {8, 2}}, 3.0));  // clockwise
  map.obstacles.push_back(test::ramp(3, {{3, 3}, 0.0}, 1, 1, 0.1));
  map.obstacles.push_back(test::stairs(4, {{5, 3}, 0.0}, 4, 0.2, 2));
  const auto planner = planner_of(map);
  EXPECT_EQ(planner.components().size(), 2U);
  EXPECT_EQ(planner.state({1.5, 5}), PlaceState::kBlocked);
  EXPECT_EQ(planner.state({6, 3.5}), PlaceState::kBlocked);
  EXPECT_EQ(planner.state({3.5, 3.5}), PlaceState::kFree);
  const auto avoiding = planner_of(map, {.ramps = RampPolicy::kAvoid});
  EXPECT_EQ(avoiding.state({3.5, 3.5}), PlaceState::kBlocked);
  EXPECT_EQ(planner.component_at({0.5, 5}), 0U);
  EXPECT_EQ(planner.component_at({5, 7}), 1U);
  EXPECT_EQ(planner.component_at({1.5, 5}), std::nullopt);
}

TEST(ExactPlanner, AnswersTheSameAgain) {
  const Map map = test::cluttered_square(3);
  const auto first = planner_of(map, {.radius_m = 0.2});
  const auto second = planner_of(map, {.radius_m = 0.2});
  Random random(9);
  ExactWorkspace workspace;
  for (int i = 0; i < 50; ++i) {
    const Point a{random.uniform(0, 60), random.uniform(0, 60)};
    const Point b{random.uniform(0, 60), random.uniform(0, 60)};
    EXPECT_EQ(first.plan(a, b, workspace).path, second.plan(a, b).path);
  }
}

}  // namespace
}  // namespace mapwright::navcore
