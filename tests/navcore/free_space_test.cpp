#include "navcore/free_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mapcore/geometry/orientation.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright::navcore {
namespace {

using namespace mapwright::test;

TEST(FreeSpace, ColumnIsSolidWithinAndFreeOnItsBoundary) {
  const FreeSpace space(map10({box(7, 4, 4, 6, 6)}));
  EXPECT_TRUE(space.is_free({1, 1}));
  EXPECT_FALSE(space.is_free({5, 5}));
  EXPECT_TRUE(space.is_free({4, 5}));
  EXPECT_TRUE(space.is_free({6, 6}));
  EXPECT_EQ(space.solid_at({5, 5}), 0U);
  EXPECT_FALSE(space.solid_at({1, 1}).has_value());
}

TEST(FreeSpace, BorderLimitsItAndIsFreeItself) {
  const FreeSpace space(map10({}));
  EXPECT_TRUE(space.is_free({0, 0}));
  EXPECT_TRUE(space.is_free({10, 5}));
  EXPECT_FALSE(space.is_free({10.001, 5}));
  EXPECT_FALSE(space.is_free({std::numeric_limits<double>::quiet_NaN(), 5}));
  EXPECT_FALSE(space.solid_at({11, 5}).has_value());
  EXPECT_DOUBLE_EQ(space.clearance_m({4, 9}), 1.0);
  EXPECT_TRUE(space.is_free({4, 9}, 1.0));
  EXPECT_FALSE(space.is_free({4, 9}, 1.001));
}

TEST(FreeSpace, InvertedBorderHasNoFreeSpace) {
  const FreeSpace space(map({10, 0, 0, 10}, {}));
  Random random(1);
  EXPECT_FALSE(space.is_free({5, 5}));
  EXPECT_FALSE(space.sample(random).has_value());
}

TEST(FreeSpace, CourtyardIsFreeAndAKioskInItSolid) {
  const FreeSpace space(
      map10({box(1, 1, 1, 9, 9), hollow(2, 2, 2, 8, 8, "inner_of=1"), box(3, 4, 4, 6, 6)}));
  EXPECT_FALSE(space.is_free({1.5, 5}));
  EXPECT_TRUE(space.is_free({3, 5}));
  EXPECT_TRUE(space.is_free({2, 5}));
  EXPECT_FALSE(space.is_free({5, 5}));
  EXPECT_TRUE(space.is_free({0.5, 5}));
  EXPECT_EQ(space.solid_at({1.5, 5}), 0U);
  EXPECT_EQ(space.solid_at({5, 5}), 2U);
}

TEST(FreeSpace, CourtyardWhoseVertexWasRoundedAcrossTheOutlineIsTiedByItsToken) {
  const FreeSpace tied(map10(
      {box(1, 1, 1, 9, 9), ring(2, {{0.999, 2}, {2, 8}, {8, 8}, {8, 2}}, 3.0, "inner_of=1")}));
  EXPECT_TRUE(tied.is_free({5, 5}));
  EXPECT_FALSE(tied.is_free({8.5, 5}));
}

TEST(FreeSpace, SolidThatReachesIntoAnothersCourtyardStaysSolid) {
  const FreeSpace space(map10({box(1, 1, 1, 9, 9), hollow(2, 2, 2, 8, 8), box(3, 7, 4, 9.5, 6)}));
  EXPECT_FALSE(space.is_free({7.5, 5}));
  EXPECT_TRUE(space.is_free({6.5, 5}));
}

TEST(FreeSpace, BuildingDrawnTwiceKeepsItsCourtyard) {
  const FreeSpace space(map10({box(1, 1, 1, 9, 9), box(2, 1, 1, 9, 9), hollow(3, 2, 2, 8, 8)}));
  EXPECT_TRUE(space.is_free({5, 5}));
  EXPECT_FALSE(space.is_free({1.5, 5}));
}

TEST(FreeSpace, OverlappingSolidsAreTheirUnion) {
  const FreeSpace space(map10({box(1, 1, 1, 5, 5), box(2, 4, 4, 8, 8)}));
  EXPECT_FALSE(space.is_free({4.5, 4.5}));
  EXPECT_FALSE(space.is_free({4, 4.5}));  // on the outline of one, within the other
  EXPECT_TRUE(space.is_free({6, 2}));
}

TEST(FreeSpace, RoomDrawnFromInsideIsSolidOutside) {
  const FreeSpace space(map10({hollow(1, 2, 2, 8, 8), box(2, 4, 4, 6, 6)}));
  EXPECT_TRUE(space.is_free({3, 3}));
  EXPECT_FALSE(space.is_free({5, 5}));
  EXPECT_FALSE(space.is_free({1, 1}));
  EXPECT_TRUE(space.is_free({2, 5}));
  EXPECT_EQ(space.solid_at({1, 5}), 0U);
}

TEST(FreeSpace, RoomsDrawnFromInsideWithAPilasterThroughAWall) {
  const FreeSpace space(
      map10({hollow(1, 1, 1, 4, 9), hollow(2, 6, 1, 9, 9), box(3, 3.5, 4, 4.5, 5)}));
  EXPECT_TRUE(space.is_free({2, 5}));
  EXPECT_TRUE(space.is_free({7, 5}));
  EXPECT_FALSE(space.is_free({3.7, 4.5}));
  EXPECT_FALSE(space.is_free({5, 5}));
}

TEST(FreeSpace, OneReversedBuildingDoesNotMakeACampusSolid) {
  const FreeSpace space(map10({hollow(1, 1, 1, 3, 3), box(2, 6, 6, 8, 8)}));
  EXPECT_TRUE(space.is_free({5, 5}));
  EXPECT_FALSE(space.is_free({7, 7}));
}

TEST(FreeSpace, RingWithADoorOfHeightZeroIsOpen) {
  Obstacle room = box(1, 2, 2, 8, 8);
  room.segments[0].height_m = 0.0;
  const FreeSpace space(map10({room}));
  EXPECT_TRUE(space.is_free({5, 5}));
  EXPECT_TRUE(space.is_free_way({5, 5}, {5, 1}, 0.0));
  EXPECT_FALSE(space.is_free_way({5, 5}, {9, 5}, 0.0));
}

TEST(FreeSpace, BrokenOutlineBlocksButIsNotSolid) {
  Obstacle broken = box(1, 2, 2, 8, 8);
  broken.segments.pop_back();
  const FreeSpace space(map10({broken}));
  EXPECT_TRUE(space.is_free({5, 5}));
  EXPECT_FALSE(space.is_free_way({5, 5}, {9, 5}, 0.0));
  EXPECT_TRUE(space.is_free_way({5, 5}, {1, 5}, 0.0));
}

TEST(FreeSpace, OpenWallBlocksWaysAndTakesClearanceOnBothSides) {
  const FreeSpace space(map10({wall(1, {{2, 5}, {8, 5}})}));
  EXPECT_TRUE(space.is_free({5, 5}));
  EXPECT_DOUBLE_EQ(space.clearance_m({5, 5.5}), 0.5);
  EXPECT_DOUBLE_EQ(space.clearance_m({5, 4.5}), 0.5);
  EXPECT_FALSE(space.is_free_way({5, 4}, {5, 6}, 0.0));
  EXPECT_TRUE(space.is_free_way({1.5, 4}, {1.5, 6}, 0.5));
  EXPECT_FALSE(space.is_free_way({1.6, 4}, {1.6, 6}, 0.5));
}

TEST(FreeSpace, PointWayMayTouchWithItsEndsOnly) {
  const FreeSpace space(map10({box(1, 4, 4, 6, 6)}));
  EXPECT_TRUE(space.is_free_way({4, 5}, {1, 5}, 0.0));
  EXPECT_TRUE(space.is_free_way({4, 4}, {1, 1}, 0.0));
  EXPECT_FALSE(space.is_free_way({4, 5}, {6, 5}, 0.0));  // through the solid
  EXPECT_FALSE(space.is_free_way({4, 5}, {9, 5}, 0.0));  // through it and beyond
  EXPECT_FALSE(space.is_free_way({4, 2}, {4, 8}, 0.0));  // along its side
  EXPECT_FALSE(space.is_free_way({3, 5}, {5, 7}, 0.0));  // grazes a corner
}

class StairsOrder : public testing::TestWithParam<bool> {};

TEST_P(StairsOrder, AreaIsSolidAndFlanksBlock) {
  const Obstacle flight = GetParam() ? stairs_top_down(1, 3, 7, 4, 4) : stairs(1, 3, 7, 4, 4);
  const FreeSpace space(map10({flight}));
  EXPECT_FALSE(space.is_free({5, 4.5}));
  EXPECT_FALSE(space.is_free({5, 5.1}));
  EXPECT_EQ(space.solid_at({5, 4.5}), 0U);
  EXPECT_TRUE(space.is_free({5, 3.9}));
  EXPECT_TRUE(space.is_free({5, 5.3}));
  EXPECT_TRUE(space.is_free({2.9, 4.5}));
  EXPECT_NEAR(space.clearance_m({2.5, 4.45}), 0.5, 1e-12);  // the flank
  EXPECT_FALSE(space.is_free_way({2, 4.45}, {8, 4.45}, 0.0));
  EXPECT_FALSE(space.is_free_way({5, 3}, {5, 6}, 0.0));
  EXPECT_NEAR(space.clearance_m({5, 5.4}), 0.2, 1e-12);  // the closing segment of height 0
}

INSTANTIATE_TEST_SUITE_P(BottomUpAndTopDown, StairsOrder, testing::Bool());

TEST(FreeSpace, RampsAreFreeOrAvoided) {
  const Map with_ramp = map10({ramp(1, 4, 4, 6, 6)});
  const FreeSpace free(with_ramp, RampPolicy::kFree);
  EXPECT_TRUE(free.is_free({5, 5}, 0.5));
  EXPECT_TRUE(free.is_free_way({1, 5}, {9, 5}, 0.5));
  const FreeSpace avoid(with_ramp, RampPolicy::kAvoid);
  EXPECT_FALSE(avoid.is_free({5, 5}));
  EXPECT_FALSE(avoid.is_free_way({1, 5}, {9, 5}, 0.0));
  EXPECT_EQ(avoid.solid_at({5, 5}), 0U);
}

TEST(FreeSpace, RampAndStairsOutsideOfARoomDoNotOpenItsOutside) {
  const Map floor = map10({hollow(1, 2, 2, 8, 8), ramp(2, 8, 4, 9, 5), stairs(3, 3, 5, 8, 3)});
  EXPECT_FALSE(FreeSpace(floor, RampPolicy::kAvoid).is_free({9.5, 9.5}));
}

TEST(FreeSpace, SegmentsWithoutPlaceAreIgnored) {
  Obstacle nowhere = box(1, 4, 4, 6, 6);
  nowhere.segments[1].a.x = std::numeric_limits<double>::quiet_NaN();
  const FreeSpace space(map10({nowhere, {2, ShapeType::kStairs, "", {}}}));
  EXPECT_EQ(space.segments().size(), 3U);
  EXPECT_TRUE(space.is_free({5, 5}));
}

TEST(FreeSpace, SamplesAreFreeUniformAndRepeatable) {
  const FreeSpace space(map10({box(1, 0, 0, 5, 10)}));
  Random random(42);
  Random same(42);
  int upper = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point p = space.sample(random, 0.5).value();
    EXPECT_EQ(p, space.sample(same, 0.5).value());
    ASSERT_TRUE(space.is_free(p, 0.5));
    upper += p.y > 5.0;
  }
  EXPECT_NEAR(upper, 10000, 400);  // 5.6 standard deviations
}

TEST(FreeSpace, SamplesASmallRoomInAWideBorder) {
  const FreeSpace space(map({-5000, 5000, 5000, -5000}, {hollow(1, 123, 456, 125, 458)}));
  Random random(3);
  int right = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto p = space.sample(random);
    ASSERT_TRUE(p.has_value());
    ASSERT_TRUE(space.is_free(*p));
    right += p->x > 124.0;
  }
  EXPECT_NEAR(right, 1000, 130);
}

TEST(FreeSpace, NoSampleWhereNothingIsFree) {
  const FreeSpace space(map10({box(1, -1, -1, 11, 11)}));
  Random random(3);
  EXPECT_FALSE(space.sample(random).has_value());
}

// The definition in so many words: every ring against every point.
class SlowSolids {
 public:
  explicit SlowSolids(const Map& map) {
    for (const auto& obstacle : map.obstacles) rings_.push_back(chain_points(obstacle));
    for (const auto& ring : rings_) {
      hollow_.push_back(ring_orientation(ring) == RingOrientation::kClockwise);
    }
  }

  bool is_solid(Point p) const {
    for (std::size_t s = 0; s < rings_.size(); ++s) {
      if (!hollow_[s] && side_of_ring(rings_[s], p) == PointSide::kInside && !is_hollowed(s, p)) {
        return true;
      }
    }
    return false;
  }

 private:
  bool is_hollowed(std::size_t solid, Point p) const {
    for (std::size_t h = 0; h < rings_.size(); ++h) {
      if (hollow_[h] && side_of_ring(rings_[h], p) != PointSide::kOutside &&
          lies_within(h, solid)) {
        return true;
      }
    }
    return false;
  }
  bool lies_within(std::size_t inner, std::size_t outer) const {
    return std::all_of(rings_[inner].begin(), rings_[inner].end(), [&](Point p) {
      return side_of_ring(rings_[outer], p) != PointSide::kOutside;
    });
  }

  std::vector<std::vector<Point>> rings_;
  std::vector<bool> hollow_;
};

// A star-shaped polygon on a grid of 0.25 m, where vertices, edges and test points often coincide.
std::vector<Point> random_star(Random& random, Point center, double radius) {
  const auto snap = [](double value) { return std::round(value * 4.0) / 4.0; };
  std::vector<Point> points;
  const int corners = 3 + static_cast<int>(random.below(6));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.8 * random.uniform()) / corners;
    const double r = radius * random.uniform(0.5, 1.0);
    points.push_back({snap(center.x + r * std::cos(angle)), snap(center.y + r * std::sin(angle))});
  }
  return points;
}

Map random_map(Random& random) {
  std::vector<Obstacle> obstacles;
  for (std::int64_t id = 0; obstacles.size() < 12; ++id) {
    const Point center{random.uniform(0, 20), random.uniform(0, 20)};
    const auto outline = random_star(random, center, random.uniform(1.0, 6.0));
    if (!is_simple_ring(outline)) continue;
    if (ring_orientation(outline) != RingOrientation::kCounterClockwise) continue;
    obstacles.push_back(ring(id, outline));
    const auto court = random_star(random, center, 1.0);
    if (is_simple_ring(court) && ring_orientation(court) == RingOrientation::kCounterClockwise) {
      obstacles.push_back(ring(1000 + id, reversed(court)));
    }
  }
  return map({0, 20, 20, 0}, std::move(obstacles));
}

TEST(FreeSpace, AgreesWithTheDefinitionOnGeneratedMaps) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Map generated = random_map(random);
    const FreeSpace space(generated);
    const SlowSolids slow(generated);
    for (int i = 0; i < 400; ++i) {
      const Point p = i % 2 == 0 ? Point{random.uniform(0, 20), random.uniform(0, 20)}
                                 : Point{0.25 * static_cast<double>(random.below(81)),
                                         0.25 * static_cast<double>(random.below(81))};
      ASSERT_EQ(space.is_free(p), !slow.is_solid(p))
          << "seed " << seed << " at " << p.x << ' ' << p.y;
    }
  }
}

}  // namespace
}  // namespace mapwright::navcore
