// The exact planner against a planner too slow for anything else.
#include <gtest/gtest.h>

#include "navcore/exact/barrier_proof.hpp"
#include "navcore/exact/path_check.hpp"
#include "tests/navcore_exact/random_maps.hpp"
#include "tests/navcore_exact/slow_paths.hpp"

namespace mapwright::navcore {
namespace {

// Start and goal on half metres: in the open, on walls, in corners, in solids.
Point half_point(Random& random) {
  return {0.5 * static_cast<double>(random.below(41)), 0.5 * static_cast<double>(random.below(41))};
}

struct Tally {
  int maps = 0, solved = 0, unreachable = 0, blocked = 0, proofs = 0;
};

void compare(const Map& map, const ExactPlanner& planner, Point start, Point goal, Tally& tally) {
  const FreeSpace space(map);
  const ExactAnswer answer = planner.plan(start, goal);
  const auto expected_m = test::slow_shortest_length_m(map, start, goal);
  if (answer.start != PlaceState::kFree || answer.goal != PlaceState::kFree) {
    // FreeSpace lets a point stand on an outline that has solids on both sides.
    ASSERT_FALSE(expected_m && start != goal);
    ++tally.blocked;
    return;
  }
  ASSERT_TRUE(space.is_free(start) && space.is_free(goal));
  ASSERT_EQ(answer.verdict == Verdict::kReachable, expected_m.has_value());
  if (!expected_m) {
    ++tally.unreachable;
    ++tally.proofs;
    ASSERT_TRUE(proves_unreachable(map, RampPolicy::kFree, answer.barrier, start, goal, 0.0));
    return;
  }
  ++tally.solved;
  ASSERT_NEAR(answer.length_m, *expected_m, 1e-9 * (1.0 + *expected_m));
  ASSERT_EQ(answer.path.front(), start);
  ASSERT_EQ(answer.path.back(), goal);
  ASSERT_TRUE(is_path_clear(map.border, space.segments(), answer.path, 0.0));
}

void compare_many(int kind, std::uint64_t seed, int wanted, Tally& tally) {
  Random random(seed);
  while (tally.maps < wanted) {
    const Map map = test::whole_map(random, kind);
    const auto planner = ExactPlanner::build(map, {});
    ASSERT_TRUE(planner.has_value()) << planner.error().message;
    if (planner->snapping_error_m() > 0.0) continue;  // the slow planner knows no grid
    ++tally.maps;
    for (int i = 0; i < 4; ++i) {
      const Point start = half_point(random), goal = half_point(random);
      SCOPED_TRACE(testing::Message()
                   << "seed " << seed << " map " << tally.maps << " from " << start.x << ","
                   << start.y << " to " << goal.x << "," << goal.y);
      compare(map, *planner, start, goal, tally);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ExactPlannerDifferential, AgreesWithAVisibilityGraphOnBoxesAndWalls) {
  Tally tally;
  compare_many(0, 1, 600, tally);
  EXPECT_GT(tally.solved, 600);
  EXPECT_GT(tally.unreachable, 10);
  EXPECT_EQ(tally.proofs, tally.unreachable);  // also between places on outlines
}

TEST(ExactPlannerDifferential, AgreesWithAVisibilityGraphOnTriangles) {
  Tally tally;
  compare_many(1, 2, 400, tally);
  EXPECT_GT(tally.solved, 400);
}

}  // namespace
}  // namespace mapwright::navcore
