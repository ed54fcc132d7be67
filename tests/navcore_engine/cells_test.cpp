// What cells list, and what they leave out.
#include "navcore/engine/cell_compiler.hpp"

#include <gtest/gtest.h>

#include "bench/support/campus_generator.hpp"
#include "navcore/engine/umbra.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::navcore::engine {
namespace {

constexpr Reach kReach{0.5, 15.0, 1.0};

CellWalls list(std::vector<Obstacle> obstacles, Point center) {
  return compile_cell(Scene(test::map10(std::move(obstacles))), kReach, center);
}

TEST(Cells, LeaveOutTheFarSidesOfSolids) {
  EXPECT_EQ(list({test::box(1, 4, 4, 6, 6)}, {1.5, 5.0}).two_sided.size(), 1U);
  EXPECT_EQ(list({test::box(1, 4, 4, 6, 6)}, {1.5, 1.5}).two_sided.size(), 2U);
  EXPECT_EQ(list({test::box(1, 4, 4, 6, 6)}, {5.0, 5.0}).two_sided.size(), 4U);  // within
  EXPECT_EQ(list({test::box(1, 4, 4, 6, 6)}, {4.2, 5.0}).two_sided.size(), 4U);  // on its wall
}

TEST(Cells, LeaveOutTheFarSideOfAConcaveSolid) {
  const Obstacle angle = test::ring(1, {{4, 4}, {8, 4}, {8, 5}, {5, 5}, {5, 8}, {4, 8}});
  // From below left both outer sides show, and nothing else of it.
  EXPECT_EQ(list({angle}, {1.5, 1.5}).two_sided.size(), 2U);
  EXPECT_EQ(list({angle}, {7.5, 7.5}).two_sided.size(), 4U);
}

TEST(Cells, LeaveOutWhatIsHiddenOrOutOfRange) {
  const auto hidden =
      list({test::wall(1, {{4, 0}, {4, 10}}), test::wall(2, {{6, 4}, {6, 6}})}, {1.5, 5.5});
  EXPECT_EQ(hidden.two_sided.size(), 1U);
  EXPECT_EQ(list({test::wall(1, {{4, 0}, {4, 10}})}, {30.5, 5.5}).two_sided.size(), 0U);
}

TEST(Cells, LeaveOutWhatSeveralWallsOfAChainHideTogether) {
  const Obstacle bulge = test::wall(1, {{4, 2}, {3.5, 5}, {4, 8}});
  const auto walls = list({bulge, test::wall(2, {{7, 4}, {7, 6}})}, {1.5, 5.5});
  EXPECT_EQ(walls.two_sided.size(), 2U);
}

TEST(Cells, KeepWhatALowWallDoesNotHide) {
  const auto walls =
      list({test::wall(1, {{4, 0}, {4, 10}}, 0.5), test::wall(2, {{6, 4}, {6, 6}})}, {1.5, 5.5});
  EXPECT_EQ(walls.two_sided.size(), 1U);
}

TEST(Cells, TreatStairsSeenFromBelowAsWalls) {
  const auto walls = list({test::stairs(1, 0, 10, 5, 5)}, {5.5, 1.5});
  EXPECT_EQ(walls.two_sided.size(), 1U);  // the first step higher than the laser hides the others
  EXPECT_TRUE(walls.stairs.empty());
}

TEST(Cells, ForgetStairsSeenFromAbove) {
  const auto walls = list({test::stairs(1, 0, 10, 5, 5)}, {5.5, 8.5});
  EXPECT_TRUE(walls.two_sided.empty());
  EXPECT_TRUE(walls.stairs.empty());
}

TEST(Cells, ForgetLowStepsOfStairsSeenFromAboveAndAside) {
  const auto walls = list({test::stairs(1, 4, 6, 2, 6)}, {1.5, 6.5});
  ASSERT_EQ(walls.stairs.size(), 1U);
  EXPECT_EQ(walls.stairs[0].tops.size(), 1U);
  EXPECT_FALSE(walls.stairs[0].stops.empty());
  EXPECT_TRUE(walls.stairs[0].low_steps.empty());
}

TEST(Cells, KeepRampsOnTheirLowSideOnly) {
  EXPECT_EQ(list({test::ramp(1, 2, 2, 10, 8)}, {1.5, 5.5}).one_sided.size(), 1U);
  EXPECT_EQ(list({test::ramp(1, 2, 2, 10, 8)}, {9.5, 5.5}).one_sided.size(), 0U);
}

TEST(Cells, CutLongWallsOutOfReach) {
  const auto walls = list({test::wall(1, {{-1000, 4}, {1000, 4}})}, {0.5, 0.5});
  ASSERT_EQ(walls.two_sided.size(), 1U);
  EXPECT_NEAR(walls.two_sided[0].b.x, 15.5, 1.0);
}

TEST(Umbra, HidesWhatNoCornerOfTheSquareSees) {
  const auto umbra = Umbra::of({3, -2}, {3, 2}, Square{0.5});
  ASSERT_TRUE(umbra);
  EXPECT_TRUE(umbra->hides({6, -3}, {6, 3}));
  EXPECT_FALSE(umbra->hides({6, -3}, {6, 5}));
  EXPECT_FALSE(umbra->hides({2, -1}, {2, 1}));  // in front
  EXPECT_FALSE(umbra->hides({3, -1}, {3, 1}));  // on it
  EXPECT_TRUE(umbra->hides({3, 2}, {5, 2.5}));  // joins it
  EXPECT_FALSE(Umbra::of({0.2, -2}, {0.2, 2}, Square{0.5}));
}

TEST(Umbra, AChainThatBendsAwayHidesPartByPart) {
  std::vector<Umbra> umbras;
  add_chord_umbras(std::vector<Point>{{3, -4}, {3, -1}, {4, 0}, {3, 1}, {3, 4}}, Square{0.5},
                   umbras);
  for (const Umbra& umbra : umbras) EXPECT_FALSE(umbra.hides({3.5, -0.2}, {3.5, 0.2}));
}

}  // namespace
}  // namespace mapwright::navcore::engine
