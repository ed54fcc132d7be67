// Bottlenecks: where the largest disc gets stuck.
#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "navcore/exact/clearance_table.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

ExactPlanner planner_of(const Map& map) {
  auto planner = ExactPlanner::build(map, {});
  EXPECT_TRUE(planner.has_value());
  return std::move(*planner);
}

// Two rooms, a wall of 0.3 m between them, a door in it.
Map two_rooms(double door_m) {
  Map map{{0, 10, 20, 0}, {}};
  map.obstacles.push_back(test::box(1, {9.85, 0, 10.15, 4}, 1.0));
  map.obstacles.push_back(test::box(2, {9.85, 4 + door_m, 10.15, 10}, 1.0));
  return map;
}

TEST(Bottleneck, IsTheDoorBetweenTwoRooms) {
  const auto planner = planner_of(two_rooms(0.8));
  const auto narrow = planner.bottleneck({5, 5}, {15, 5});
  ASSERT_TRUE(narrow.has_value());
  EXPECT_NEAR(narrow->width_m, 0.8, 1e-12);
  EXPECT_NEAR(distance(narrow->from, narrow->to), 0.8, 1e-9);
  EXPECT_NEAR(narrow->at.y, 4.4, 1e-9);
  EXPECT_FALSE(narrow->is_end);
  EXPECT_EQ(std::minmax(*narrow->obstacle_from, *narrow->obstacle_to), std::minmax(0U, 1U));
}

TEST(Bottleneck, IsAnEndWhereNothingIsNarrower) {
  const auto narrow = planner_of(two_rooms(2.0)).bottleneck({5, 0.25}, {15, 5});
  ASSERT_TRUE(narrow.has_value());
  EXPECT_TRUE(narrow->is_end);
  EXPECT_NEAR(narrow->width_m, 0.5, 1e-12);
  EXPECT_EQ(narrow->obstacle_from, std::nullopt);  // the border
}

TEST(Bottleneck, IsNowhereWhereNothingPasses) {
  Map map{{0, 10, 20, 0}, {}};
  map.obstacles.push_back(test::wall(1, {10, 0}, {10, 10}, 1.0));
  const auto planner = planner_of(map);
  EXPECT_FALSE(planner.bottleneck({5, 5}, {15, 5}).has_value());
  EXPECT_FALSE(planner.bottleneck({10, 5}, {15, 5}).has_value());
  EXPECT_FALSE(planner.bottleneck({5, std::nan("")}, {15, 5}).has_value());
  EXPECT_TRUE(planner.bottleneck({5, 5}, {6, 7}).has_value());
  EXPECT_TRUE(planner.bottleneck({5, 5}, {5, 5}).has_value());
}

// The wall and the border share an edge of the medial axis on each side of the wall.
TEST(Bottleneck, TellsTheSidesOfAWallApart) {
  Map map{{0, 20, 20, 0}, {}};
  map.obstacles.push_back(test::wall(1, {14, 0}, {14, 19}, 1.0));
  const auto planner = planner_of(map);
  for (const double y_m : {17.0, 18.0, 18.2}) {
    const auto narrow = planner.bottleneck({10.9, 14.5}, {15.3, y_m});
    ASSERT_TRUE(narrow.has_value());
    EXPECT_NEAR(narrow->width_m, 1.0, 1e-12);
    EXPECT_EQ(planner.region_at({15.3, y_m}, 0.6), planner.region_at({18, 5}, 0.6));
    EXPECT_NE(planner.region_at({15.3, y_m}, 0.6), planner.region_at({10.9, 14.5}, 0.6));
  }
}

TEST(Bottleneck, LiesBetweenACornerAndAWall) {
  Map map{{0, 10, 20, 0}, {}};
  map.obstacles.push_back(test::outline(1, {{8, 0}, {12, 0}, {10.5, 9.3}}, 1.0));
  const auto narrow = planner_of(map).bottleneck({3, 3}, {17, 3});
  ASSERT_TRUE(narrow.has_value());
  EXPECT_NEAR(narrow->width_m, 0.7, 1e-12);
  EXPECT_NEAR(narrow->at.x, 10.5, 1e-9);
}

// The widest way over a grid of points, each as wide as the clearance there.
double widest_on_grid_m(const FreeSpace& space, Point a, Point b, double cell_m) {
  const auto n = static_cast<int>(test::kSide_m / cell_m) + 1;
  const auto at = [&](int i, int j) { return Point{i * cell_m, j * cell_m}; };
  const auto number = [&](Point p) {
    return static_cast<int>(std::lround(p.x / cell_m)) * n +
           static_cast<int>(std::lround(p.y / cell_m));
  };
  std::vector<char> done(static_cast<std::size_t>(n * n));
  std::priority_queue<std::pair<double, int>> queue;
  queue.emplace(space.clearance_m(a), number(a));
  while (!queue.empty()) {
    const auto [clearance_m, cell] = queue.top();
    queue.pop();
    if (cell == number(b)) return 2.0 * clearance_m;
    if (done[cell] != 0) continue;
    done[cell] = 1;
    for (const auto& [di, dj] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const int i = cell / n + di, j = cell % n + dj;
      if (i < 0 || j < 0 || i >= n || j >= n || done[i * n + j] != 0) continue;
      queue.emplace(std::min(clearance_m, space.clearance_m(at(i, j))), i * n + j);
    }
  }
  return 0.0;
}

TEST(Bottleneck, AgreesWithAFineGrid) {
  Random random(31);
  constexpr double kCell_m = 0.1;
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    const Map map = test::whole_map(random, round % 2);
    const FreeSpace space(map);
    const auto planner = planner_of(map);
    for (int i = 0; i < 3; ++i) {
      const auto draw = [&] {
        return Point{kCell_m * static_cast<double>(1 + random.below(199)),
                     kCell_m * static_cast<double>(1 + random.below(199))};
      };
      const Point a = draw(), b = draw();
      if (!(space.clearance_m(a) > 0.0) || !(space.clearance_m(b) > 0.0)) continue;
      const auto narrow = planner.bottleneck(a, b);
      const double on_grid_m = widest_on_grid_m(space, a, b, kCell_m);
      // Between grid points the way can be wider by a diagonal, and a narrow one may be missed.
      const double width_m = narrow ? narrow->width_m : 0.0;
      SCOPED_TRACE(testing::Message()
                   << round << ": " << a.x << "," << a.y << " to " << b.x << "," << b.y);
      ASSERT_GE(width_m, on_grid_m - 2.0 * kCell_m);
      ASSERT_LE(width_m, on_grid_m + 2.0 * kCell_m);
      ++compared;
    }
  }
  EXPECT_GT(compared, 80);
}

// What the widths say of a disc, the offset free space says as well.
TEST(Bottleneck, AgreesWithTheDiscPlanner) {
  Random random(32);
  int passed = 0, stuck = 0;
  for (int round = 0; round < 100; ++round) {
    const Map map = test::crowded_map(random);
    const double radius_m = 0.15 + 0.1 * static_cast<double>(random.below(8)) + 0.017;
    auto disc = ExactPlanner::build(map, {.radius_m = radius_m});
    ASSERT_TRUE(disc.has_value());
    for (int i = 0; i < 4; ++i) {
      const Point a{random.uniform(0, 20), random.uniform(0, 20)};
      const Point b{random.uniform(0, 20), random.uniform(0, 20)};
      if (disc->state(a) != PlaceState::kFree || disc->state(b) != PlaceState::kFree) continue;
      const auto narrow = disc->bottleneck(a, b);
      const bool passes = narrow && narrow->width_m >= 2.0 * radius_m;
      const auto answer = disc->plan(a, b);
      if (answer.verdict != Verdict::kUndecided) {
        ASSERT_EQ(answer.verdict == Verdict::kReachable, passes) << round;
      }
      ++(passes ? passed : stuck);
    }
  }
  EXPECT_GT(passed, 40);
  EXPECT_GT(stuck, 5);
}

}  // namespace
}  // namespace mapwright::navcore
