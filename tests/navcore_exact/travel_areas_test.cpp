// Areas a robot can travel, what keeps them apart, and how they shrink as the robot grows.
#include "navcore/exact/travel_areas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "navcore/exact/clearance_table.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

// Two rooms, a wall of 0.3 m between them, a door in it.
Map two_rooms(double door_m) {
  Map map{{0, 10, 20, 0}, {}};
  map.obstacles.push_back(test::box(1, {9.85, 0, 10.15, 4}, 1.0));
  map.obstacles.push_back(test::box(2, {9.85, 4 + door_m, 10.15, 10}, 1.0));
  return map;
}

TravelAreas areas_of(const Map& map, double radius_m) {
  auto areas = TravelAreas::build(map, radius_m, RampPolicy::kFree);
  EXPECT_TRUE(areas.has_value());
  return std::move(*areas);
}

TEST(TravelAreas, AreKeptApartByTheDoor) {
  const auto areas = areas_of(two_rooms(0.8), 0.41);
  ASSERT_EQ(areas.areas().size(), 2U);
  const auto& gap = areas.areas()[1].gap;
  ASSERT_TRUE(gap.has_value());
  EXPECT_FALSE(areas.areas()[0].gap.has_value());
  EXPECT_NEAR(gap->width_m, 0.8, 1e-12);
  EXPECT_NEAR(gap->at.y, 4.4, 1e-9);
  EXPECT_EQ(std::minmax(*gap->obstacle_from, *gap->obstacle_to), std::minmax(0U, 1U));
  // Upper end of the lower wall, lower end of the upper one: each where two sides meet.
  for (const auto& [obstacle, segment] : {std::pair(gap->obstacle_from, gap->segment_from),
                                          std::pair(gap->obstacle_to, gap->segment_to)}) {
    ASSERT_TRUE(segment.has_value());
    const Segment& side = two_rooms(0.8).obstacles[*obstacle].segments[*segment];
    EXPECT_TRUE(side.a.y == gap->from.y || side.b.y == gap->from.y || side.a.y == gap->to.y ||
                side.b.y == gap->to.y);
  }
  EXPECT_NE(areas.area_at({5, 5}), areas.area_at({15, 5}));
  EXPECT_EQ(areas.area_at({10, 1}), std::nullopt);
}

// The offset of 1.5 mm would keep the rooms apart; the widths know better.
TEST(TravelAreas, HaveNoErrorOfTheOffsetInThem) {
  EXPECT_EQ(areas_of(two_rooms(0.8), 0.4).areas().size(), 1U);
  EXPECT_EQ(areas_of(two_rooms(0.8), 0.3995).areas().size(), 1U);
  EXPECT_EQ(areas_of(two_rooms(0.8), 0.4001).areas().size(), 2U);
  EXPECT_DOUBLE_EQ(areas_of(two_rooms(0.8), 0.4).largest_fraction(), 1.0);
}

TEST(TravelAreas, HaveNoGapWhereNothingGetsOut) {
  Map map{{0, 10, 20, 0}, {}};
  map.obstacles.push_back(test::wall(1, {10, 0}, {10, 10}, 1.0));
  const auto areas = areas_of(map, 0.3);
  ASSERT_EQ(areas.areas().size(), 2U);
  EXPECT_FALSE(areas.areas()[1].gap.has_value());
}

TEST(TravelAreas, AgreeWithTheVerdictsOfThePlanner) {
  Random random(33);
  int same = 0, apart = 0;
  for (int round = 0; round < 100; ++round) {
    const Map map = test::crowded_map(random);
    const double radius_m = 0.15 + 0.1 * static_cast<double>(random.below(8)) + 0.017;
    const auto areas = areas_of(map, radius_m);
    for (int i = 0; i < 4; ++i) {
      const Point a{random.uniform(0, 20), random.uniform(0, 20)};
      const Point b{random.uniform(0, 20), random.uniform(0, 20)};
      const auto area_a = areas.area_at(a), area_b = areas.area_at(b);
      if (!area_a || !area_b) continue;
      const auto verdict = areas.planner().plan(a, b).verdict;
      if (verdict == Verdict::kUndecided) continue;
      ASSERT_EQ(verdict == Verdict::kReachable, area_a == area_b) << round;
      ++(area_a == area_b ? same : apart);
    }
  }
  EXPECT_GT(same, 40);
  EXPECT_GT(apart, 5);
}

TEST(ClearanceTable, FallsWhereTheDoorGetsTooNarrow) {
  Map map = two_rooms(0.8);
  map.obstacles.push_back(test::box(3, {1, 1, 1.5, 1.5}, 1.0));
  map.obstacles.back().semantic = "bench,name=West bench";
  map.obstacles.push_back(test::box(4, {18, 1, 18.5, 1.5}, 1.0));
  map.obstacles.back().semantic = "bench,name=East bench";
  map.obstacles.push_back(test::box(5, {16, 1, 16.5, 1.5}, 1.0));
  const double radii_m[] = {0.41, 0.0, 0.39, 4.0, 6.0, 0.0};
  const auto table = clearance_table(map, RampPolicy::kFree, radii_m);
  ASSERT_TRUE(table.has_value());
  const auto& rows = table->rows;
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(table->places, 2U);
  EXPECT_EQ(rows[0].components, 1U);
  EXPECT_NEAR(rows[0].free_area_m2, 200.0 - 0.3 * 9.2 - 3 * 0.25, 1e-9);
  EXPECT_EQ(rows[1].components, 1U);
  EXPECT_EQ(rows[1].share(), 1.0);
  EXPECT_TRUE(rows[1].places_lost.empty());
  EXPECT_EQ(rows[2].components, 2U);
  EXPECT_NEAR(rows[2].share(), 0.5, 0.02);
  EXPECT_EQ(rows[2].places_lost, std::vector<std::string>{"East bench"});
  EXPECT_EQ(rows[3].places_lost, std::vector<std::string>{"West bench"});
  EXPECT_EQ(rows[4].components, 0U);
  EXPECT_EQ(rows[4].share(), 0.0);
  EXPECT_TRUE(rows[4].places_lost.empty());
  const double wrong[] = {-1.0};
  EXPECT_FALSE(clearance_table(map, RampPolicy::kFree, wrong).has_value());
}

}  // namespace
}  // namespace mapwright::navcore
