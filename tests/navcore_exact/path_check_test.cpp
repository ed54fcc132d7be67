// Second opinions on paths of a point that touch walls.
#include "navcore/exact/path_check.hpp"

#include <gtest/gtest.h>

#include "navcore/exact/exact_planner.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

using Path = std::vector<Point>;

const Border kBorder{0, 10, 10, 0};

bool is_clear(const std::vector<BlockingSegment>& walls, const Path& path) {
  return is_path_clear(kBorder, walls, path, 0.0);
}

// Two walls that share the point (5, 5), with solids or nothing beside them.
const std::vector<BlockingSegment> kBentWall{{{0, 5}, {5, 5}}, {{5, 5}, {10, 6}}};

TEST(PathCheck, SeesASlipThroughASharedPoint) {
  EXPECT_FALSE(is_clear(kBentWall, {{5, 2}, {5, 5}, {5, 8}}));
  EXPECT_FALSE(is_clear(kBentWall, {{5, 2}, {5, 8}}));  // no vertex of the path there
  EXPECT_FALSE(is_clear(kBentWall, {{4, 2}, {5, 5}, {9, 9}}));
}

TEST(PathCheck, AllowsTouchingASharedPoint) {
  EXPECT_TRUE(is_clear(kBentWall, {{5, 2}, {5, 5}, {9, 2}}));
  EXPECT_TRUE(is_clear(kBentWall, {{5, 8}, {5, 5}, {1, 8}}));
  EXPECT_TRUE(is_clear(kBentWall, {{1, 2}, {5, 5}}));
}

TEST(PathCheck, SeesASlipBetweenBoxesThatTouchAtACorner) {
  std::vector<BlockingSegment> walls;
  for (const auto& box : {test::box(1, {1, 1, 5, 5}, 1.0), test::box(2, {5, 5, 9, 9}, 1.0)}) {
    for (const auto& segment : box.segments) walls.push_back({segment.a, segment.b});
  }
  EXPECT_FALSE(is_clear(walls, {{8, 2}, {5, 5}, {2, 8}}));
  EXPECT_FALSE(is_clear(walls, {{8, 2}, {2, 8}}));
  EXPECT_FALSE(is_clear(walls, {{5, 2}, {5, 8}}));         // along one, and along the other beyond
  EXPECT_TRUE(is_clear(walls, {{5, 2}, {5, 5}, {9, 5}}));  // around the inner corner
}

TEST(PathCheck, RemembersTheSideOfAWallItRunsAlong) {
  const std::vector<BlockingSegment> wall{{{0, 5}, {8, 5}}};
  EXPECT_TRUE(is_clear(wall, {{1, 2}, {2, 5}, {6, 5}, {7, 2}}));
  EXPECT_FALSE(is_clear(wall, {{1, 2}, {2, 5}, {6, 5}, {7, 8}}));
  EXPECT_TRUE(is_clear(wall, {{1, 2}, {2, 5}, {8, 5}, {7, 8}}));   // around its end
  EXPECT_TRUE(is_clear(wall, {{1, 2}, {2, 5}, {9, 5}, {7, 8}}));   // beyond it, on the same leg
  EXPECT_TRUE(is_clear(wall, {{2, 5}, {6, 5}, {7, 8}}));           // a start on it is on both sides
  EXPECT_FALSE(is_clear(wall, {{2, 2}, {2, 5}, {2, 8}}));          // a vertex on it
  EXPECT_FALSE(is_clear(wall, {{2, 2}, {2, 5}, {2, 5}, {2, 8}}));  // the same point twice
}

TEST(PathCheck, TheBorderIsAWallWhereOthersTouchIt) {
  const std::vector<BlockingSegment> wall{{{0, 5}, {8, 5}}};
  EXPECT_FALSE(is_clear(wall, {{0, 2}, {0, 8}}));
  EXPECT_TRUE(is_clear(wall, {{0, 2}, {0, 5}, {8, 5}, {0, 8}}));
}

// What the planner answers, the check accepts; and it refuses a shortcut through any wall.
TEST(PathCheck, AgreesWithThePlannerOnMapsFullOfCoincidences) {
  Random random(41);
  int paths = 0;
  for (int round = 0; round < 300; ++round) {
    const Map map = test::whole_map(random, 0);
    const auto planner = ExactPlanner::build(map, {});
    ASSERT_TRUE(planner.has_value());
    if (planner->snapping_error_m() > 0.0) continue;
    const auto segments = blocking_segments(map, RampPolicy::kFree);
    const Point a = test::whole_point(random), b = test::whole_point(random);
    const auto answer = planner->plan(a, b);
    if (answer.path.empty()) continue;
    ++paths;
    ASSERT_TRUE(is_path_clear(map.border, segments, answer.path, 0.0)) << round;
  }
  EXPECT_GT(paths, 60);
}

}  // namespace
}  // namespace mapwright::navcore
