// Proofs that there is no way.
#include "navcore/exact/barrier.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "navcore/exact/barrier_proof.hpp"
#include "tests/navcore_exact/random_maps.hpp"

namespace mapwright::navcore {
namespace {

using exact::Barrier;
using exact::GridPoint;

// A square room of 10 m with a door 0.8 m wide.
Barrier around_room() {
  Barrier barrier;
  const GridPoint corners[] = {{0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    barrier.lines.push_back({corners[i], corners[i + 1], i});
    barrier.legs.push_back({corners[i], corners[i + 1], i, i});
  }
  barrier.lines.push_back({{0, 10000}, {0, 5000}, 3});
  barrier.lines.push_back({{0, 4200}, {0, 0}, 4});
  barrier.legs.push_back({{0, 10000}, {0, 5000}, 3, 3});
  barrier.legs.push_back({{0, 5000}, {0, 4200}, 3, 4});
  barrier.legs.push_back({{0, 4200}, {0, 0}, 4, 4});
  return barrier;
}

constexpr GridPoint kInside{5000, 5000}, kOutside{-3000, 5000};

TEST(BarrierCheck, AcceptsARoomWhoseDoorIsTooNarrow) {
  EXPECT_TRUE(separates(around_room(), kInside, kOutside, 402));
  EXPECT_TRUE(separates(around_room(), kOutside, kInside, 500));
}

TEST(BarrierCheck, RefusesADoorThatIsWideEnough) {
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 400));
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 401));  // within the margin
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 0));
}

TEST(BarrierCheck, RefusesWhatDoesNotSeparate) {
  EXPECT_FALSE(separates(around_room(), kInside, {6000, 6000}, 500));
  EXPECT_FALSE(separates(around_room(), {0, 7000}, kOutside, 500));  // lies on it
  EXPECT_FALSE(separates({}, kInside, kOutside, 500));
}

TEST(BarrierCheck, RefusesAnOpenChainAndLegsAwayFromTheirLines) {
  Barrier open = around_room();
  open.legs.pop_back();
  EXPECT_FALSE(separates(open, kInside, kOutside, 500));
  Barrier away = around_room();
  away.lines[1] = {{10501, 0}, {10501, 10000}, 1};
  EXPECT_FALSE(separates(away, kInside, kOutside, 500));
  Barrier nowhere = around_room();
  nowhere.legs[0].line_from = nowhere.legs[0].line_to = 99;
  EXPECT_FALSE(separates(nowhere, kInside, kOutside, 500));
}

// From the safe side: a robot that floods the map by cells and is let through wherever a point of
// the cell might be free for it.
bool generous_flood_connects(const FreeSpace& space, Point start, Point goal, double radius_m,
                             double cell_m) {
  const auto n = static_cast<int>(test::kSide_m / cell_m);
  const double slack_m = 0.71 * cell_m;
  const auto number = [&](Point p) {
    return std::pair(std::min(n - 1, static_cast<int>(p.x / cell_m)),
                     std::min(n - 1, static_cast<int>(p.y / cell_m)));
  };
  const auto may_stand = [&](int i, int j) {
    const Point middle{(i + 0.5) * cell_m, (j + 0.5) * cell_m};
    const double to_border_m =
        std::min({middle.x, middle.y, test::kSide_m - middle.x, test::kSide_m - middle.y});
    return std::min(to_border_m, space.index().clearance_m(middle, 100.0)) >= radius_m - slack_m;
  };
  std::vector<char> seen(static_cast<std::size_t>(n * n));
  std::deque<std::pair<int, int>> waiting{number(start)};
  while (!waiting.empty()) {
    const auto [i, j] = waiting.front();
    waiting.pop_front();
    if (i < 0 || j < 0 || i >= n || j >= n || seen[i * n + j] != 0 || !may_stand(i, j)) continue;
    seen[i * n + j] = 1;
    if (std::pair(i, j) == number(goal)) return true;
    waiting.insert(waiting.end(), {{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}});
  }
  return false;
}

TEST(Barriers, AreFoundForEveryDiscThatCannotPassAndAFloodConfirmsThem) {
  Random random(21);
  int proofs = 0, confirmed = 0, undecided = 0;
  for (int round = 0; round < 300; ++round) {
    const Map map = test::crowded_map(random);
    const double radius_m = 0.2 + 0.1 * static_cast<double>(random.below(9)) + 0.013;
    const auto planner = ExactPlanner::build(map, {.radius_m = radius_m});
    ASSERT_TRUE(planner.has_value());
    const FreeSpace space(map);
    for (int i = 0; i < 6; ++i) {
      const Point a{random.uniform(0, 20), random.uniform(0, 20)};
      const Point b{random.uniform(0, 20), random.uniform(0, 20)};
      const auto answer = planner->plan(a, b);
      if (answer.start != PlaceState::kFree || answer.goal != PlaceState::kFree) continue;
      if (answer.verdict == Verdict::kUndecided) ++undecided;
      if (answer.verdict != Verdict::kUnreachable) continue;
      ++proofs;
      ASSERT_TRUE(proves_unreachable(map, RampPolicy::kFree, answer.barrier, a, b, radius_m));
      EXPECT_FALSE(proves_unreachable(map, RampPolicy::kFree, answer.barrier, a, a, radius_m));
      const Map bare{map.border, {}};
      EXPECT_FALSE(proves_unreachable(bare, RampPolicy::kFree, answer.barrier, a, b, radius_m));
      // Where a passage is nearly wide enough, only small cells tell.
      for (const double cell : {0.05, 0.02, 0.008}) {
        if (generous_flood_connects(space, a, b, radius_m, cell * radius_m)) continue;
        ++confirmed;
        break;
      }
    }
  }
  EXPECT_GT(proofs, 30);
  EXPECT_EQ(confirmed, proofs);
  EXPECT_EQ(undecided, 0);
}

}  // namespace
}  // namespace mapwright::navcore
