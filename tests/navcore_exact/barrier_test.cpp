// Proofs that there is no way.
#include "navcore/exact/barrier.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
  EXPECT_TRUE(separates(around_room(), kInside, kOutside, 400'000'001));
  EXPECT_TRUE(separates(around_room(), kOutside, kInside, 500'000'000));
}

TEST(BarrierCheck, RefusesADoorThatIsWideEnough) {
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 400'000'000));  // touches both posts
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 399'999'999));
  EXPECT_FALSE(separates(around_room(), kInside, kOutside, 0));
}

TEST(BarrierCheck, RefusesWhatDoesNotSeparate) {
  EXPECT_FALSE(separates(around_room(), kInside, {6000, 6000}, 500'000'000));
  EXPECT_FALSE(separates(around_room(), {0, 7000}, kOutside, 500'000'000));  // lies on it
  EXPECT_FALSE(separates({}, kInside, kOutside, 500'000'000));
}

// A corner 0.5 m off a slanted wall: the foot lies beside the grid, the width is irrational.
TEST(BarrierCheck, ComparesTheWidthOfAGapExactly) {
  Barrier barrier;
  barrier.lines = {{{0, 10000}, {0, 900}, 0},
                   {{-1000, -500}, {10000, 700}, 1},
                   {{10000, 700}, {10000, 10000}, 2},
                   {{10000, 10000}, {0, 10000}, 3}};
  // From the corner (0, 900) to the wall y = -500 + 12/110 (x + 1000).
  const double width_nm =
      1e6 * (900.0 + 500.0 - 1000.0 * 12.0 / 110.0) / std::hypot(1.0, 12.0 / 110.0);
  const double x_mm =
      (900.0 + 500.0 - 1000.0 * 12.0 / 110.0) * (12.0 / 110.0) / (1.0 + 144.0 / 12100.0);
  const GridPoint foot{
      static_cast<std::int32_t>(std::lround(x_mm)),
      static_cast<std::int32_t>(std::lround(-500.0 + 12.0 / 110.0 * (x_mm + 1000.0)))};
  barrier.legs = {{{0, 10000}, {0, 900}, 0, 0},
                  {{0, 900}, foot, 0, 1},
                  {foot, {10000, 700}, 1, 1},
                  {{10000, 700}, {10000, 10000}, 2, 2},
                  {{10000, 10000}, {0, 10000}, 3, 3}};
  const auto half = static_cast<std::int64_t>(std::floor(0.5 * width_nm));
  EXPECT_FALSE(separates(barrier, kInside, kOutside, half));
  EXPECT_TRUE(separates(barrier, kInside, kOutside, half + 1));
  barrier.legs[1].to.x += 2, barrier.legs[2].from.x += 2;  // not the foot
  EXPECT_FALSE(separates(barrier, kInside, kOutside, half + 1));
}

TEST(BarrierCheck, RefusesPlacesWithinRoundingOfAGap) {
  EXPECT_TRUE(separates(around_room(), {3, 4600}, kOutside, 500'000'000));
  EXPECT_FALSE(separates(around_room(), {1, 4600}, kOutside, 500'000'000));
  EXPECT_FALSE(separates(around_room(), kInside, {-1, 4600}, 500'000'000));
}

TEST(BarrierCheck, RefusesAnOpenChainAndLegsAwayFromTheirLines) {
  Barrier open = around_room();
  open.legs.pop_back();
  EXPECT_FALSE(separates(open, kInside, kOutside, 500'000'000));
  Barrier away = around_room();
  away.lines[1] = {{10501, 0}, {10501, 10000}, 1};
  EXPECT_FALSE(separates(away, kInside, kOutside, 500'000'000));
  Barrier nowhere = around_room();
  nowhere.legs[0].line_from = nowhere.legs[0].line_to = 99;
  EXPECT_FALSE(separates(nowhere, kInside, kOutside, 500'000'000));
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
