#include "navcore/reachability/reachability_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "navcore/planning/path.hpp"
#include "navcore/planning/planner.hpp"
#include "navcore/reachability/subdivision.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::navcore {
namespace {

using namespace mapwright::test;

ReachabilityOptions with_radius(double radius_m) {
  ReachabilityOptions options;
  options.radius_m = radius_m;
  return options;
}

// Two rooms of 4.9 m × 10 m and a door between them.
Map rooms_with_door(double width_m) {
  const double low = 5.0 - 0.5 * width_m;
  const double high = 5.0 + 0.5 * width_m;
  return map10({hollow(1, 0, 0, 10, 10), box(2, 4.9, 0, 5.1, low), box(3, 4.9, high, 5.1, 10)});
}

TEST(ReachabilityMap, EmptyMapIsOneArea) {
  const FreeSpace space(map10({}));
  const ReachabilityMap reach(space, with_radius(0.5));
  ASSERT_EQ(reach.areas().size(), 1U);
  EXPECT_NEAR(reach.areas()[0].area_m2, 81.0, 3.0);
  EXPECT_TRUE(reach.areas()[0].is_connected);
  EXPECT_DOUBLE_EQ(reach.largest_fraction(), 1.0);
  EXPECT_EQ(reach.connected({1, 1}, {9, 9}), Connection::kYes);
  EXPECT_EQ(reach.connected({0.4, 1}, {9, 9}), Connection::kNo);  // too near to the border
}

TEST(ReachabilityMap, DoorIsWideEnoughOrNotToTheCentimetre) {
  const FreeSpace space(rooms_with_door(0.8));
  for (const double radius : {0.1, 0.3, 0.39, 0.395}) {
    const ReachabilityMap reach(space, with_radius(radius));
    EXPECT_EQ(reach.connected({1, 1}, {9, 1}), Connection::kYes) << radius;
    ASSERT_EQ(reach.areas().size(), 1U) << radius;
    EXPECT_TRUE(reach.areas()[0].is_connected) << radius;
  }
  for (const double radius : {0.405, 0.41, 0.6, 1.5}) {
    const ReachabilityMap reach(space, with_radius(radius));
    EXPECT_EQ(reach.connected({2, 2}, {8, 2}), Connection::kNo) << radius;
    ASSERT_EQ(reach.areas().size(), 2U) << radius;
    EXPECT_NEAR(reach.largest_fraction(), 0.5, 0.02) << radius;
  }
}

TEST(ReachabilityMap, DoorAsWideAsTheRobotIsLeftUndecided) {
  const FreeSpace space(rooms_with_door(0.8));
  const ReachabilityMap reach(space, with_radius(0.4));
  EXPECT_EQ(reach.connected({1, 1}, {9, 1}), Connection::kUndecided);
  ASSERT_EQ(reach.areas().size(), 1U);
  EXPECT_FALSE(reach.areas()[0].is_connected);
}

TEST(ReachabilityMap, CoarseCellsAreSplitWhereADoorNeedsIt) {
  const FreeSpace space(rooms_with_door(0.8));
  ReachabilityOptions options = with_radius(0.39);
  options.resolution_m = 0.5;
  EXPECT_EQ(ReachabilityMap(space, options).connected({1, 1}, {9, 1}), Connection::kYes);
  options.radius_m = 0.41;
  EXPECT_EQ(ReachabilityMap(space, options).connected({1, 1}, {9, 1}), Connection::kNo);
}

TEST(ReachabilityMap, FenceSeparatesARobotWithARadius) {
  const FreeSpace space(map10({wall(1, {{5, 0}, {5, 10}})}));
  const ReachabilityMap reach(space, with_radius(0.1));
  EXPECT_EQ(reach.connected({1, 1}, {9, 1}), Connection::kNo);
  EXPECT_EQ(reach.areas().size(), 2U);
}

TEST(ReachabilityMap, FenceIsNeverProvedToStopAPointRobot) {
  const FreeSpace space(map10({wall(1, {{5, 0}, {5, 10}})}));
  const ReachabilityMap reach(space, with_radius(0.0));
  EXPECT_EQ(reach.connected({1, 1}, {9, 1}), Connection::kUndecided);
  EXPECT_EQ(reach.connected({1, 1}, {1, 9}), Connection::kYes);
}

TEST(ReachabilityMap, SolidWallStopsAPointRobot) {
  const FreeSpace space(map10({box(1, 4.5, -1, 5.5, 11)}));
  EXPECT_EQ(ReachabilityMap(space, with_radius(0.0)).connected({1, 1}, {9, 1}), Connection::kNo);
}

TEST(ReachabilityMap, CrossingAndOverlappingObstaclesSeparateToo) {
  const FreeSpace space(map10({wall(1, {{0, 4}, {6, 6}}), wall(2, {{4, 6}, {8, 3}}),
                               box(3, 7, 2, 9, 4), box(4, 8.5, 3, 11, 5)}));
  const ReachabilityMap reach(space, with_radius(0.2));
  EXPECT_EQ(reach.connected({1, 1}, {1, 9}), Connection::kNo);
  EXPECT_EQ(reach.connected({1, 1}, {9.5, 1}), Connection::kYes);
}

TEST(ReachabilityMap, NamesTheAreasWithSizeAndPlace) {
  const FreeSpace space(map10({box(1, 1, 1, 5, 5), hollow(2, 2, 2, 4, 4, "inner_of=1")}));
  const ReachabilityMap reach(space, with_radius(0.25));
  ASSERT_EQ(reach.areas().size(), 2U);
  const ReachableArea& court = reach.areas()[1];
  EXPECT_NEAR(court.area_m2, 1.5 * 1.5, 0.2);
  EXPECT_LT(court.area_m2, 1.5 * 1.5);
  EXPECT_TRUE(Box({2.2, 2.2, 3.8, 3.8}).contains(court.at));
  EXPECT_GE(space.clearance_m(court.at), 0.25);
  EXPECT_NEAR(court.box.min_x, 2.25, 0.06);
  EXPECT_EQ(reach.area_at({3, 3}), 1U);
  EXPECT_EQ(reach.area_at({8, 8}), 0U);
  EXPECT_FALSE(reach.area_at({1.5, 1.5}).has_value());
}

TEST(ReachabilityMap, NowhereToStand) {
  const FreeSpace full(map10({box(1, -1, -1, 11, 11)}));
  EXPECT_TRUE(ReachabilityMap(full, with_radius(0.0)).areas().empty());
  const FreeSpace open(map10({}));
  EXPECT_TRUE(ReachabilityMap(open, with_radius(5.1)).areas().empty());
  const FreeSpace inverted(map({10, 0, 0, 10}, {}));
  EXPECT_TRUE(ReachabilityMap(inverted, with_radius(0.1)).areas().empty());
  EXPECT_EQ(ReachabilityMap(inverted, with_radius(0.1)).largest_fraction(), 0.0);
}

TEST(ReachabilityMap, MemoryLimitLeavesTheRestUndecided) {
  const FreeSpace space(rooms_with_door(0.8));
  ReachabilityOptions options = with_radius(0.39);
  options.max_cells = 400;
  const ReachabilityMap reach(space, options);
  EXPECT_LE(reach.cell_count(), 400U);
  EXPECT_EQ(reach.connected({1, 1}, {9, 1}), Connection::kUndecided);
}

TEST(ReachabilityMap, OblongBorders) {
  const FreeSpace space(map({0, 2, 200, 0}, {wall(1, {{100, 0}, {100, 0.9}})}));
  EXPECT_EQ(ReachabilityMap(space, with_radius(0.5)).connected({1, 1}, {199, 1}), Connection::kYes);
  EXPECT_EQ(ReachabilityMap(space, with_radius(0.6)).connected({1, 1}, {199, 1}), Connection::kNo);
}

// A cluttered map of overlapping boxes and walls at all angles.
Map clutter(std::uint64_t seed) {
  Random random(seed);
  std::vector<Obstacle> obstacles;
  for (std::int64_t id = 0; id < 14; ++id) {
    const Point p{random.uniform(0, 10), random.uniform(0, 10)};
    const Point q{p.x + random.uniform(-4, 4), p.y + random.uniform(-4, 4)};
    if (id % 2 == 0) {
      obstacles.push_back(wall(id, {p, q}));
    } else {
      const double w = random.uniform(0.2, 2);
      const double h = random.uniform(0.2, 2);
      obstacles.push_back(box(id, p.x, p.y, p.x + w, p.y + h));
    }
  }
  return map10(std::move(obstacles));
}

// Flood fill over a regular grid of places, joined where the robot can move straight between them:
// whatever it connects is connected.
class FloodFill {
 public:
  FloodFill(const FreeSpace& space, double radius_m) : labels_(kSide * kSide, 0) {
    for (int i = 0; i < kSide * kSide; ++i) {
      if (labels_[i] == 0 && space.is_free(place(i), radius_m)) fill(space, radius_m, i);
    }
  }
  static Point place(int i) {
    return {(i % kSide + 0.5) * 10.0 / kSide, (i / kSide + 0.5) * 10.0 / kSide};
  }
  int label(int i) const { return labels_[i]; }
  static constexpr int kSide = 60;

 private:
  void fill(const FreeSpace& space, double radius_m, int from) {
    ++count_;
    std::vector<int> stack{from};
    labels_[from] = count_;
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      for (const int step : {-1, 1, -kSide, kSide}) {
        const int j = i + step;
        if (j < 0 || j >= kSide * kSide || (std::abs(step) == 1 && j / kSide != i / kSide))
          continue;
        if (labels_[j] != 0 || !space.is_free(place(j), radius_m)) continue;
        if (!space.is_free_way(place(i), place(j), radius_m)) continue;
        labels_[j] = count_;
        stack.push_back(j);
      }
    }
  }

  std::vector<int> labels_;
  int count_ = 0;
};

TEST(ReachabilityMap, NeverContradictsFloodFill) {
  int decided = 0;
  int no = 0;
  int all = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const FreeSpace space(clutter(seed));
    const double radius = 0.05 + 0.1 * static_cast<double>(seed % 5);
    const FloodFill flood(space, radius);
    const ReachabilityMap reach(space, with_radius(radius));
    Random random(seed);
    for (int k = 0; k < 60; ++k) {
      const int i = static_cast<int>(random.below(FloodFill::kSide * FloodFill::kSide));
      const int j = static_cast<int>(random.below(FloodFill::kSide * FloodFill::kSide));
      if (flood.label(i) == 0 || flood.label(j) == 0) continue;
      const auto answer = reach.connected(FloodFill::place(i), FloodFill::place(j));
      if (flood.label(i) == flood.label(j)) {
        EXPECT_NE(answer, Connection::kNo) << seed;
      }
      ++all;
      decided += answer != Connection::kUndecided;
      no += answer == Connection::kNo;
    }
  }
  EXPECT_GT(all, 1000);
  EXPECT_GT(no, 50);  // the maps do fall apart
  EXPECT_GT(decided, 0.98 * all);
}

TEST(ReachabilityMap, WhatIsConnectedIsPlannedAndWhatIsNotIsNot) {
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    const FreeSpace space(clutter(seed));
    const ReachabilityMap reach(space, with_radius(0.2));
    Random random(seed);
    const auto a = space.sample(random, 0.2);
    const auto b = space.sample(random, 0.2);
    if (!a || !b) continue;
    RrtOptions options;
    options.max_iterations = 5000;
    const auto plan = plan_balanced_rrt(space, {*a, *b, 0.2}, options, random);
    const auto answer = reach.connected(*a, *b);
    if (answer == Connection::kUndecided) continue;
    EXPECT_EQ(plan.solved, answer == Connection::kYes) << seed;
  }
}

TEST(ProvePassage, HoldsForEveryPointOfTheCell) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FreeSpace space(clutter(seed));
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
      const Point center{random.uniform(-1, 11), random.uniform(-1, 11)};
      const double half = random.uniform(0.01, 0.5);
      const double radius = random.uniform(0.0, 0.4);
      const Passage proof = prove_passage(
          space, {center.x - half, center.y - half, center.x + half, center.y + half}, radius);
      if (proof == Passage::kUndecided) continue;
      for (int k = 0; k < 20; ++k) {
        const Point p{center.x + random.uniform(-half, half),
                      center.y + random.uniform(-half, half)};
        if (space.border().contains(p)) {
          ASSERT_EQ(space.is_free(p, radius), proof == Passage::kFree);
        }
      }
    }
  }
}

TEST(CellTree, NeighboursAreThoseThatShareASide) {
  CellTree tree({0, 0, 16, 16}, 1.0);
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const auto cell = static_cast<CellTree::Cell>(random.below(tree.size()));
    if (tree.is_leaf(cell) && !tree.is_finest(cell)) tree.split(cell);
  }
  const auto share_side = [&](const Box& p, const Box& q) {
    const double dx = std::min(p.max_x, q.max_x) - std::max(p.min_x, q.min_x);
    const double dy = std::min(p.max_y, q.max_y) - std::max(p.min_y, q.min_y);
    return (dx == 0.0 && dy > 0.0) || (dy == 0.0 && dx > 0.0);
  };
  for (CellTree::Cell cell = 0; cell < tree.size(); ++cell) {
    if (!tree.is_leaf(cell)) continue;
    EXPECT_EQ(tree.leaf_at(tree.center(cell)), cell);
    std::set<CellTree::Cell> expected;
    for (CellTree::Cell other = 0; other < tree.size(); ++other) {
      if (tree.is_leaf(other) && share_side(tree.box(cell), tree.box(other)))
        expected.insert(other);
    }
    std::set<CellTree::Cell> found;
    tree.for_each_neighbour(cell, [&](CellTree::Cell beside) { found.insert(beside); });
    EXPECT_EQ(found, expected);
  }
  EXPECT_EQ(tree.leaf_at({17, 3}), CellTree::kNone);
}

}  // namespace
}  // namespace mapwright::navcore
