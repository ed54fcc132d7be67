#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "navcore/planning/path.hpp"
#include "navcore/planning/planner.hpp"
#include "navcore/planning/route.hpp"
#include "navcore/planning/search_tree.hpp"
#include "navcore/planning/smoothing.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/navcore/slow_collision.hpp"

namespace mapwright::navcore {
namespace {

using namespace mapwright::test;

// Two rooms within 10 m × 10 m and a door of 0.8 m between them, at y 4.6 … 5.4.
Map two_rooms() {
  return map10({hollow(1, 0, 0, 10, 10), box(2, 4.9, 0, 5.1, 4.6), box(3, 4.9, 5.4, 5.1, 10)});
}

// A labyrinth of walls, each with its gap at the other end.
Map baffles() {
  return map10({wall(1, {{2, 0}, {2, 9}}), wall(2, {{4, 1}, {4, 10}}), wall(3, {{6, 0}, {6, 9}}),
                wall(4, {{8, 1}, {8, 10}})});
}

using Planner = PlanningResult (*)(const FreeSpace&, const PlanQuery&, const RrtOptions&, Random&);

class EachPlanner : public testing::TestWithParam<Planner> {
 protected:
  static PlanningResult plan(const FreeSpace& space, const PlanQuery& query, std::uint64_t seed,
                             const RrtOptions& options = {}) {
    Random random(seed);
    return GetParam()(space, query, options, random);
  }
};

void expect_valid(const FreeSpace& space, const PlanQuery& query, const std::vector<Point>& path) {
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.front(), query.start);
  EXPECT_EQ(path.back(), query.goal);
  const double clearance = slow_clearance_m(space.segments(), path);
  EXPECT_GE(clearance, query.radius_m);
  EXPECT_GT(clearance, 0.0);
  for (const Point p : path) EXPECT_TRUE(space.is_free(p, query.radius_m));
}

TEST_P(EachPlanner, GoesStraightWhereNothingIsInTheWay) {
  const FreeSpace space(map10({}));
  const auto result = plan(space, {{1, 1}, {9, 9}, 0.5}, 1);
  EXPECT_TRUE(result.solved);
  EXPECT_EQ(result.path, (std::vector<Point>{{1, 1}, {9, 9}}));
  EXPECT_EQ(result.iterations, 0U);
  EXPECT_TRUE(result.tree.empty());
}

TEST_P(EachPlanner, FindsTheDoorWithEverySeed) {
  const FreeSpace space(two_rooms());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const double radius : {0.0, 0.3}) {
      const PlanQuery query{{1, 1}, {9, 2}, radius};
      const auto result = plan(space, query, seed);
      ASSERT_TRUE(result.solved) << seed;
      expect_valid(space, query, result.path);
      EXPECT_GT(result.iterations, 0U);
    }
  }
}

TEST_P(EachPlanner, FindsItsWayThroughBaffles) {
  const FreeSpace space(baffles());
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const PlanQuery query{{1, 1}, {9, 9}, 0.2};
    const auto result = plan(space, query, seed);
    ASSERT_TRUE(result.solved) << seed;
    expect_valid(space, query, result.path);
  }
}

TEST_P(EachPlanner, RangeLimitAndGoalBiasGiveValidPathsToo) {
  const FreeSpace space(baffles());
  RrtOptions options;
  options.max_extension_m = 1.0;
  options.goal_bias = 0.1;
  const PlanQuery query{{1, 1}, {9, 9}, 0.2};
  const auto result = plan(space, query, 7, options);
  ASSERT_TRUE(result.solved);
  expect_valid(space, query, result.path);
  for (const auto& edge : result.tree) EXPECT_LE(distance(edge.from, edge.to), 1.0 + 1e-12);
}

TEST_P(EachPlanner, GivesUpAtTheIterationLimit) {
  const FreeSpace space(two_rooms());
  RrtOptions options;
  options.max_iterations = 300;
  const auto result = plan(space, {{1, 1}, {9, 9}, 0.41}, 5, options);
  EXPECT_FALSE(result.solved);
  EXPECT_TRUE(result.path.empty());
  EXPECT_EQ(result.iterations, 300U);
  EXPECT_FALSE(result.tree.empty());
}

TEST_P(EachPlanner, SameSeedSamePathOtherSeedAnother) {
  const FreeSpace space(baffles());
  const PlanQuery query{{1, 1}, {9, 9}, 0.0};
  EXPECT_EQ(plan(space, query, 3).path, plan(space, query, 3).path);
  EXPECT_NE(plan(space, query, 3).path, plan(space, query, 4).path);
}

TEST_P(EachPlanner, StartsAndEndsOnOutlines) {
  const FreeSpace space(map10({box(1, 4, 4, 6, 6)}));
  const auto result = plan(space, {{4, 5}, {6, 5}, 0.0}, 1);
  ASSERT_TRUE(result.solved);
  EXPECT_TRUE(is_free_path(space, result.path, 0.0));
}

TEST_P(EachPlanner, TreeEdgesAreFree) {
  const FreeSpace space(baffles());
  for (const auto& edge : plan(space, {{1, 1}, {9, 9}, 0.1}, 3).tree) {
    EXPECT_GE(slow_clearance_m(space.segments(), {edge.from, edge.to}), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, EachPlanner, testing::Values(&plan_rrt, &plan_balanced_rrt),
                         [](const auto& each) { return each.index == 0 ? "Rrt" : "BalancedRrt"; });

TEST(BalancedRrt, NeedsFewerIterationsThroughNarrowPassages) {
  const FreeSpace space(baffles());
  std::size_t plain = 0;
  std::size_t balanced = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random first(seed);
    Random second(seed);
    plain += plan_rrt(space, {{1, 1}, {9, 9}, 0.3}, {}, first).iterations;
    balanced += plan_balanced_rrt(space, {{1, 1}, {9, 9}, 0.3}, {}, second).iterations;
  }
  EXPECT_LT(balanced, plain);
}

TEST(SearchTree, NearestAgreesWithLookingAtAll) {
  Random random(9);
  const auto coordinate = [&] { return 0.5 * static_cast<double>(random.below(40)); };
  SearchTree tree({10, 10});
  for (int i = 0; i < 500; ++i) tree.add({coordinate(), coordinate()}, 0);
  for (int i = 0; i < 200; ++i) {
    const Point p{coordinate(), random.uniform(0, 20)};
    std::vector<double> all;
    for (SearchTree::Node n = 0; n < tree.size(); ++n) all.push_back(distance(tree.point(n), p));
    std::sort(all.begin(), all.end());
    std::size_t rank = 0;
    for (const auto node : tree.nearest(p)) {
      EXPECT_DOUBLE_EQ(distance(tree.point(node), p), all[rank++]);
    }
    EXPECT_EQ(rank, SearchTree::kMostNeighbours);
  }
}

TEST(Path, ClearanceIsThatOfTheWholeLeg) {
  const FreeSpace space(map10({box(1, 4, 4, 6, 6)}));
  const std::vector<Point> path{{1, 7}, {9, 7}, {9, 1}};
  EXPECT_DOUBLE_EQ(path_clearance_m(space, path).value(), 1.0);
  EXPECT_DOUBLE_EQ(path_length_m(path), 14.0);
  EXPECT_EQ(path_clearance_m(space, std::vector<Point>{{1, 5}, {9, 5}}), 0.0);
  EXPECT_FALSE(path_clearance_m(FreeSpace(map10({})), path).has_value());
}

TEST(Path, ClearanceAgreesWithLookingAtAll) {
  const FreeSpace space(baffles());
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    std::vector<Point> path;
    for (int k = 0; k < 3; ++k) path.push_back({random.uniform(0, 10), random.uniform(0, 10)});
    EXPECT_DOUBLE_EQ(path_clearance_m(space, path).value(),
                     slow_clearance_m(space.segments(), path));
  }
}

TEST(Smoothing, NeverCollidesNeverLongerSameEnds) {
  const FreeSpace space(baffles());
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const PlanQuery query{{1, 1}, {9, 9}, seed % 2 == 0 ? 0.0 : 0.25};
    Random random(seed);
    const auto raw = plan_rrt(space, query, {}, random).path;
    const auto smooth = smooth_path(space, raw, query.radius_m, {}, random);
    expect_valid(space, query, smooth);
    EXPECT_LE(path_length_m(smooth), path_length_m(raw));
  }
}

TEST(Smoothing, ComesNearTheShortestPath) {
  const FreeSpace space(baffles());
  const std::vector<Point> shortest{{1, 1}, {2, 9}, {4, 1}, {6, 9}, {8, 1}, {9, 9}};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const auto raw = plan_balanced_rrt(space, {{1, 1}, {9, 9}, 0.0}, {}, random).path;
    const auto smooth = smooth_path(space, raw, 0.0, {}, random);
    EXPECT_LT(path_length_m(smooth), 1.02 * path_length_m(shortest)) << seed;
    EXPECT_GE(path_length_m(smooth), path_length_m(shortest));
  }
}

TEST(Smoothing, KeepsExtraClearanceWherePossible) {
  const FreeSpace space(map10({box(1, 4, 4, 6, 6)}));
  const std::vector<Point> raw{{1, 5}, {1, 9}, {9, 9}, {9, 5}};
  Random random(1);
  const auto near = smooth_path(space, raw, 0.0, {}, random);
  const auto far = smooth_path(space, raw, 0.0, {200, 1.0}, random);
  EXPECT_LT(path_clearance_m(space, near), 0.5);
  EXPECT_GE(path_clearance_m(space, far), 1.0);
  EXPECT_LT(path_length_m(far), path_length_m(raw));
}

LegPlanner balanced(const FreeSpace& space) {
  return [&space](const PlanQuery& query, Random& random) {
    return plan_balanced_rrt(space, query, {}, random);
  };
}

TEST(Route, PassesThroughViaPoints) {
  const FreeSpace space(baffles());
  const std::vector<Point> stops{{1, 1}, {1, 9.5}, {5, 5}, {9, 9}};
  const auto route = plan_route(space, stops, 0.1, balanced(space), SmoothingOptions{}, 4);
  ASSERT_TRUE(route.total.solved);
  expect_valid(space, {stops.front(), stops.back(), 0.1}, route.total.path);
  auto next = stops.begin();
  for (const Point p : route.total.path) next += next != stops.end() && p == *next;
  EXPECT_EQ(next, stops.end());
  EXPECT_LE(path_length_m(route.total.path), path_length_m(route.raw_path));
}

TEST(Route, NamesTheLegThatFails) {
  const FreeSpace space(map10({wall(1, {{5, 0}, {5, 10}})}));
  const LegPlanner brief = [&](const PlanQuery& query, Random& random) {
    RrtOptions options;
    options.max_iterations = 50;
    return plan_rrt(space, query, options, random);
  };
  const std::vector<Point> stops{{1, 1}, {2, 2}, {9, 9}, {8, 8}};
  const auto route = plan_route(space, stops, 0.0, brief, std::nullopt, 4);
  EXPECT_FALSE(route.total.solved);
  EXPECT_EQ(route.failed_leg, 2U);
  EXPECT_TRUE(route.total.path.empty());
}

TEST(Route, FindsAPointOnARamp) {
  const Map with_ramp = map10({ramp(1, 4, 4, 6, 6), box(2, 4.5, 4.5, 5.5, 5.5)});
  const FreeSpace space(with_ramp);
  const Point p = point_on_ramp(space, with_ramp.obstacles[0], 0.2).value();
  EXPECT_TRUE(space.is_free(p, 0.2));
  EXPECT_TRUE(extent(with_ramp.obstacles[0]).contains(p));
  EXPECT_FALSE(point_on_ramp(space, with_ramp.obstacles[0], 1.0).has_value());
}

}  // namespace
}  // namespace mapwright::navcore
