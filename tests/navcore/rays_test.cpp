// The rules of docs/rays.md, worked out by hand; both ray casters must give these numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"
#include "navcore/rays/ray_fan.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

using test::box;
using test::chain;
using test::ramp;
using test::stairs;
using test::wall;

struct Caster {
  const char* name;
  std::function<std::unique_ptr<RayCaster>(const Map&)> make;
};

void PrintTo(const Caster& caster, std::ostream* out) {
  *out << caster.name;
}

class Rays : public testing::TestWithParam<Caster> {
 protected:
  std::vector<double> scan(const std::vector<Obstacle>& obstacles, const Pose& pose,
                           const LaserModel& laser) {
    const auto caster = GetParam().make({{-50, 50, 50, -50}, obstacles});
    std::vector<double> ranges(laser.rays, -1.0);
    caster->cast(pose, laser, ranges);
    return ranges;
  }

  // One ray from (x, y) in the direction of `deg`, RMAX 15 m.
  double ray(const std::vector<Obstacle>& obstacles, double x, double y, double deg,
             double height_m = 0.5) {
    return scan(obstacles, {x, y, Angle::from_degrees(deg)}, {1, 180.0, 15.0, height_m}).front();
  }
};

INSTANTIATE_TEST_SUITE_P(Casters, Rays,
                         testing::Values(Caster{"brute_force",
                                                [](const Map& map) {
                                                  return std::make_unique<BruteForceRayCaster>(map);
                                                }},
                                         Caster{"culled",
                                                [](const Map& map) {
                                                  return std::make_unique<CulledRayCaster>(map);
                                                }}),
                         [](const auto& caster) { return caster.param.name; });

TEST_P(Rays, RunFromMinusToPlusHalfTheFieldOfView) {
  const std::vector<Obstacle> room{box(1, {-2, -3, 4, 5}, 2)};
  EXPECT_EQ(scan(room, {0, 0, Angle()}, {3, 180, 15, 0.5}), (std::vector<double>{3, 4, 5}));
  EXPECT_EQ(scan(room, {0, 0, Angle()}, {5, 360, 15, 0.5}), (std::vector<double>{2, 3, 4, 5, 2}));
  EXPECT_EQ(scan(room, {0, 0, Angle()}, {2, 180, 15, 0.5}), (std::vector<double>{3, 5}));
  EXPECT_EQ(scan(room, {0, 0, Angle::from_degrees(90)}, {3, 180, 15, 0.5}),
            (std::vector<double>{4, 5, 2}));
  EXPECT_EQ(scan(room, {0, 0, Angle::from_degrees(-90)}, {1, 10, 15, 0.5}),
            (std::vector<double>{3}));
}

TEST_P(Rays, GiveTheMaximumRangeWhereNothingIsNearEnough) {
  EXPECT_EQ(ray({}, 0, 0, 0), 15.0);
  EXPECT_EQ(ray({wall(1, {15, -1}, {15, 1}, 2)}, 0, 0, 0), 15.0);
  EXPECT_EQ(ray({wall(1, {15.001, -1}, {15.001, 1}, 2)}, 0, 0, 0), 15.0);
  EXPECT_EQ(ray({wall(1, {14.999, -1}, {14.999, 1}, 2)}, 0, 0, 0), 14.999);
  EXPECT_EQ(ray({wall(1, {-1, -1}, {-1, 1}, 2)}, 0, 0, 0), 15.0) << "behind the robot";
}

TEST_P(Rays, AreStoppedByWhatIsHigherThanTheLaserOnly) {
  const std::vector<Obstacle> walls{wall(1, {1, -1}, {1, 1}, 0.4), wall(2, {2, -1}, {2, 1}, 0.5),
                                    wall(3, {3, -1}, {3, 1}, 0.501)};
  EXPECT_EQ(ray(walls, 0, 0, 0, 0.5), 3.0) << "a wall as high as the laser is crossed";
  EXPECT_EQ(ray(walls, 0, 0, 0, 0.4), 2.0);
  EXPECT_EQ(ray(walls, 0, 0, 0, 0.39), 1.0);
  EXPECT_EQ(ray(walls, 0, 0, 0, 0.6), 15.0);
}

TEST_P(Rays, AreStoppedFromBothSides) {
  EXPECT_EQ(ray({wall(1, {2, -1}, {2, 1}, 2)}, 0, 0, 0), 2.0);
  EXPECT_EQ(ray({wall(1, {2, 1}, {2, -1}, 2)}, 0, 0, 0), 2.0);
}

TEST_P(Rays, HitAWallAtItsEnd) {
  EXPECT_EQ(ray({wall(1, {3, 0}, {3, 7}, 2)}, 0, 0, 0), 3.0);
  EXPECT_EQ(ray({wall(1, {3, 0.001}, {3, 7}, 2)}, 0, 0, 0), 15.0);
}

TEST_P(Rays, RunningAlongAWallHitItsNearestPoint) {
  EXPECT_EQ(ray({wall(1, {2, 0}, {6, 0}, 2)}, 0, 0, 0), 2.0);
  EXPECT_EQ(ray({wall(1, {6, 0}, {2, 0}, 2)}, 0, 0, 0), 2.0);
  EXPECT_EQ(ray({wall(1, {-1, 0}, {2, 0}, 2)}, 0, 0, 0), 0.0) << "the robot stands in the wall";
  EXPECT_EQ(ray({wall(1, {-3, 0}, {-1, 0}, 2)}, 0, 0, 0), 15.0) << "the wall lies behind";
}

TEST_P(Rays, FromAWallAreStoppedAtOnce) {
  EXPECT_EQ(ray({wall(1, {0, -1}, {0, 1}, 2)}, 0, 0, 0), 0.0);
  EXPECT_EQ(ray({wall(1, {0, 0}, {0, 1}, 2)}, 0, 0, 0), 0.0) << "at the wall's end";
  EXPECT_EQ(ray({wall(1, {-1, -1}, {1, 1}, 2)}, 0, 0, 0), 0.0);
  EXPECT_FALSE(std::signbit(ray({wall(1, {0, 1}, {0, -1}, 2)}, 0, 0, 180)));
}

TEST_P(Rays, SeeAZeroLengthSegmentAsAPoint) {
  EXPECT_EQ(ray({wall(1, {2, 0}, {2, 0}, 2)}, 0, 0, 0), 2.0);
  EXPECT_EQ(ray({wall(1, {2, 0.5}, {2, 0.5}, 2)}, 0, 0, 0), 15.0);
}

TEST_P(Rays, FromBelowStopAtTheFirstStepAboveTheLaser) {
  // Steps at y = 0, 0.3, 0.6, 0.9 of heights 0.2, 0.4, 0.6, 0.8; top at 1.2.
  const std::vector<Obstacle> flight{stairs(1, {{-2, 0}, 0}, 4, 0.2, 4)};
  EXPECT_DOUBLE_EQ(ray(flight, 0, -1, 90, 0.5), 1.6);
  EXPECT_DOUBLE_EQ(ray(flight, 0, -1, 90, 0.1), 1.0);
  EXPECT_DOUBLE_EQ(ray(flight, 0, -1, 90, 0.39), 1.3);
}

TEST_P(Rays, FromAboveCrossTheWholeStaircase) {
  const std::vector<Obstacle> flight{stairs(1, {{-2, 0}, 0}, 4, 0.2, 4),
                                     wall(2, {-2, -3}, {2, -3}, 2)};
  EXPECT_DOUBLE_EQ(ray(flight, 0, 2, -90, 0.5), 5.0) << "the wall beyond the stairs";
  EXPECT_DOUBLE_EQ(ray(flight, 0, 2, -90, 0.1), 5.0);
}

TEST_P(Rays, OverStairsLowerThanTheLaserPass) {
  EXPECT_EQ(ray({stairs(1, {{-2, 0}, 0}, 2, 0.2, 4)}, 0, -1, 90, 0.5), 15.0);
  EXPECT_EQ(ray({stairs(1, {{-2, 0}, 0}, 2, 0.25, 4)}, 0, -1, 90, 0.5), 15.0)
      << "a step exactly as high as the laser does not stop it";
}

TEST_P(Rays, FromTheSideMeetStepsOrTopFirst) {
  // From beside the stairs: flanks are open, so the ray meets what its line crosses first.
  const std::vector<Obstacle> flight{stairs(1, {{0, 0}, 0}, 4, 0.2, 4)};
  const double down = -std::atan2(2.4, 2.0) * 180.0 / M_PI;
  // From (−1, 2.2) down to (1, −0.2): crosses the top y = 1.2 at x = −1 + 1/1.2 < 0, outside, then
  // y = 0.9 at x ≈ 0.083: a step, 0.8 m high.
  EXPECT_NEAR(ray({flight[0]}, -1, 2.2, down, 0.5), std::hypot(1.3 / 1.2, 1.3), 1e-12);
  // Along a step's edge, from its end.
  EXPECT_DOUBLE_EQ(ray(flight, -1, 0.9, 0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(ray(flight, -1, 0.3, 0, 0.5), 15.0) << "this step is lower than the laser";
  EXPECT_DOUBLE_EQ(ray(flight, -1, 1.2, 0, 0.5), 15.0) << "along the top";
}

TEST_P(Rays, CountAStepWhereStepAndTopAreMetAtOnce) {
  Obstacle flight = stairs(1, {{0, 0}, 0}, 1, 1.0, 2);
  flight.segments[1].a = flight.segments[0].b;
  flight.segments[1].b = flight.segments[0].a;
  EXPECT_EQ(ray({flight}, 1, -2, 90, 0.5), 2.0);
  EXPECT_EQ(ray({flight}, 1, 2, -90, 0.5), 2.0);
}

TEST_P(Rays, KeepStaircasesApart) {
  // Upstairs of the first flight means nothing to the second.
  const std::vector<Obstacle> flights{stairs(1, {{-2, 0}, 0}, 4, 0.2, 4),
                                      stairs(2, {{2, -3}, M_PI}, 4, 0.2, 4)};
  // The second rises towards −y from y = −3; seen from above over the first it is met from below.
  EXPECT_NEAR(ray(flights, 0, 2, -90, 0.5), 5.6, 1e-12);
}

TEST_P(Rays, UphillStopWhereTheRampReachesTheLaser) {
  const std::vector<Obstacle> slope{ramp(1, {{-2, 0}, 0}, 4, 10, 0.1)};
  EXPECT_NEAR(ray(slope, 0, -1, 90, 0.5), 6.0, 1e-7);
  EXPECT_NEAR(ray(slope, 0, -1, 90, 0.25), 3.5, 1e-7);
  EXPECT_NEAR(ray(slope, 0, 2, 90, 0.5), 3.0, 1e-7) << "from on the ramp";
  EXPECT_EQ(ray(slope, 0, -1, 90, 1.01), 15.0) << "the ramp ends below the laser";
}

TEST_P(Rays, FromTheHighSideOrAlongTheContourPassOverARamp) {
  const std::vector<Obstacle> slope{ramp(1, {{-2, 0}, 0}, 4, 10, 0.1)};
  EXPECT_EQ(ray(slope, 0, 11, -90, 0.5), 15.0) << "down the ramp";
  EXPECT_EQ(ray(slope, -5, 7, 0, 0.5), 15.0) << "sideways, above the laser all the way";
  EXPECT_EQ(ray(slope, -5, 2, 0, 0.5), 15.0) << "sideways, below the laser all the way";
}

TEST_P(Rays, FromTheSideStopAtARampOnlyWhereItRisesToThem) {
  const std::vector<Obstacle> slope{ramp(1, {{-2, 0}, 0}, 4, 10, 0.1)};
  // At 45° from (−4, 3): enters the footprint at (−2, 5), where the ramp is as high as the laser,
  // so one metre further right it would enter above it.
  EXPECT_NEAR(ray(slope, -3.5, 3, 45, 0.5), 2 * std::sqrt(2.0), 1e-7);
  EXPECT_EQ(ray(slope, -4.5, 3, 45, 0.5), 15.0) << "enters above the laser";
  EXPECT_EQ(ray(slope, 1.5, 3, 45, 0.5), 15.0) << "leaves before the ramp is high enough";
}

TEST_P(Rays, SeeOnlyTheContourInsideOfAFootprintThatIsNotConvex) {
  // A U of two ramps joined at the foot: at height 0.5 two pieces with a gap between x = −1 and 1.
  Obstacle u = test::outline(
      1, {{-3, 0}, {3, 0}, {3, 10}, {1, 10}, {1, 2}, {-1, 2}, {-1, 10}, {-3, 10}}, 0.0);
  u.shape_type = ShapeType::kRamp;
  const double scale = 1.0 / std::hypot(1.0, 0.1);
  u.semantic =
      Semantic("ramp").with_value(semantic_key::kNormal, format_normal({0, -0.1 * scale, scale}));
  EXPECT_NEAR(ray({u}, -2, -1, 90, 0.5), 6.0, 1e-7);
  EXPECT_NEAR(ray({u}, 2, -1, 90, 0.5), 6.0, 1e-7);
  EXPECT_EQ(ray({u}, 0, -1, 90, 0.5), 15.0);
}

TEST_P(Rays, IgnoreARampWithoutUsableSurface) {
  Obstacle slope = ramp(1, {{-2, 0}, 0}, 4, 10, 0.1);
  for (const char* semantic : {"ramp", "ramp,normal=0:0:1", "ramp,normal=0:0.1:-1", "normal=x"}) {
    slope.semantic = semantic;
    EXPECT_EQ(ray({slope}, 0, -1, 90), 15.0) << semantic;
  }
  slope.segments.clear();
  EXPECT_EQ(ray({slope}, 0, -1, 90), 15.0);
}

TEST_P(Rays, TakeTheNearestOfAllObstacles) {
  const std::vector<Obstacle> all{wall(1, {9, -1}, {9, 1}, 2), box(2, {5, -1, 6, 1}, 2),
                                  wall(3, {7, -1}, {7, 1}, 2)};
  EXPECT_EQ(ray(all, 0, 0, 0), 5.0);
}

// A round tower of chords that share their ends: rays aimed at the very corners must not slip in.
TEST_P(Rays, NeverLeakThroughASharedVertex) {
  std::vector<Point> ring;
  for (int i = 0; i < 97; ++i) {
    const double angle = 2 * M_PI * i / 97;
    ring.push_back(
        {test::to_millimetres(7 * std::cos(angle)), test::to_millimetres(7 * std::sin(angle))});
  }
  const auto caster = GetParam().make({{-9, 9, 9, -9}, {test::outline(1, ring, 2)}});
  Random random(5);
  double range = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Point from{random.uniform(-4, 4), random.uniform(-4, 4)};
    const Point to = ring[random.below(ring.size())] - from;
    const Pose pose{from.x, from.y, Angle::from_radians(std::atan2(to.y, to.x))};
    caster->cast(pose, {1, 180, 15, 0.5}, {&range, 1});
    ASSERT_NEAR(range, length(to), 0.01) << from.x << ' ' << from.y;
  }
}

TEST_P(Rays, NeverLeakThroughTheCornersOfATown) {
  // From grid points along the diagonals and axes, straight at corners on whole metres.
  const std::vector<Obstacle> blocks{box(1, {2, 2, 4, 4}, 2), box(2, {4, 4, 6, 6}, 2)};
  EXPECT_NEAR(ray(blocks, 6, 2, 135), std::hypot(2, 2), 1e-12) << "two blocks touch at a corner";
  EXPECT_NEAR(ray(blocks, 0, 0, 45), std::hypot(2, 2), 1e-12);
  EXPECT_EQ(ray(blocks, 0, 2, 0), 2.0);
  EXPECT_EQ(ray(blocks, 4, 0, 90), 2.0);
}

TEST_P(Rays, OfManyPosesAreThoseOfEach) {
  const auto caster = GetParam().make(test::cluttered_square(3));
  const LaserModel laser{31, 270, 12, 0.4};
  const std::vector<Pose> poses{{5, 5, Angle()}, {20, 30, Angle::from_degrees(77)}};
  std::vector<double> all(2 * laser.rays), one(laser.rays);
  caster->cast_all(poses, laser, all);
  for (std::size_t i = 0; i < 2; ++i) {
    caster->cast(poses[i], laser, one);
    EXPECT_TRUE(std::equal(one.begin(), one.end(), all.begin() + i * laser.rays));
  }
}

TEST(RayFan, IsExactAtRightAngles) {
  const LaserModel laser{5, 360, 15, 0.5};
  RayFan fan(laser);
  fan.turn(RayFan(laser), Angle::from_degrees(270));
  const std::vector<Point> expected{{0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(fan[i], expected[i]) << i;
}

}  // namespace
}  // namespace mapwright::navcore
