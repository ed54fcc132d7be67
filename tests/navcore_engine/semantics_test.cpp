// The report's rules for rays (docs/rays.md), one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "navcore/rays/brute_force_ray_caster.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/navcore_engine/engines.hpp"

namespace mapwright::navcore {
namespace {

using test::on_each_instruction_set;

double look(const ScanEngine& engine, Point from, double degrees, double height_m = 0.5) {
  const LaserModel laser{1, 180.0, 15.0, height_m};
  double range = -1.0;
  engine.cast({from.x, from.y, Angle::from_degrees(degrees)}, laser, {&range, 1});
  return range;
}

constexpr double kClose = 1e-4;

TEST(ScanEngineRules, AWallStopsARayIfItIsHigher) {
  on_each_instruction_set(test::map10({test::wall(1, {{5, 0}, {5, 10}}, 1.0)}),
                          [](const ScanEngine& engine) {
                            EXPECT_NEAR(look(engine, {2, 3}, 0, 0.99), 3.0, kClose);
                            EXPECT_EQ(look(engine, {2, 3}, 0, 1.0), 15.0);
                            EXPECT_EQ(look(engine, {2, 3}, 180, 0.5), 15.0);
                          });
}

TEST(ScanEngineRules, AFenceIsSeenFromBothSides) {
  on_each_instruction_set(test::map10({test::wall(1, {{5, 0}, {5, 10}})}),
                          [](const ScanEngine& engine) {
                            EXPECT_NEAR(look(engine, {4, 3}, 0), 1.0, kClose);
                            EXPECT_NEAR(look(engine, {6, 3}, 180), 1.0, kClose);
                          });
}

TEST(ScanEngineRules, InsideOfASolidItsWallsAreSeenFromWithin) {
  on_each_instruction_set(test::map10({test::box(1, 2, 2, 8, 8), test::box(2, 4, 4, 5, 5)}),
                          [](const ScanEngine& engine) {
                            EXPECT_NEAR(look(engine, {3, 4.5}, 180), 1.0, kClose);
                            EXPECT_NEAR(look(engine, {3, 4.5}, 0), 1.0, kClose);
                            EXPECT_NEAR(look(engine, {4.5, 4.5}, 90), 0.5, kClose);
                          });
}

TEST(ScanEngineRules, StairsFromBelowStopAtTheFirstStepHigherThanTheLaser) {
  for (const Obstacle& stairs :
       {test::stairs(1, 0, 10, 5, 5), test::stairs_top_down(1, 0, 10, 5, 5)}) {
    on_each_instruction_set(test::map10({stairs}), [](const ScanEngine& engine) {
      EXPECT_NEAR(look(engine, {5, 1}, 90, 0.1), 4.0, kClose);
      EXPECT_NEAR(look(engine, {5, 1}, 90, 0.5), 4.6, kClose);
      EXPECT_EQ(look(engine, {5, 1}, 90, 1.0), 15.0);
    });
  }
}

TEST(ScanEngineRules, StairsFromAboveAreCrossed) {
  on_each_instruction_set(
      test::map10({test::stairs(1, 0, 10, 5, 5), test::wall(2, {{0, 2}, {10, 2}})}),
      [](const ScanEngine& engine) {
        EXPECT_NEAR(look(engine, {5, 9}, -90), 7.0, kClose);  // the wall beyond
        EXPECT_NEAR(look(engine, {9, 9}, -120, 0.1), 7.0 / std::cos(30 * 0.017453292519943295),
                    kClose);
      });
}

TEST(ScanEngineRules, ARayFromTheFlankMeetsStepsBetweenTops) {
  on_each_instruction_set(test::map10({test::stairs(1, 4, 6, 5, 5)}), [](const ScanEngine& engine) {
    EXPECT_NEAR(look(engine, {3, 4.7}, 45, 0.5), 1.2 * std::sqrt(2.0), kClose);
    EXPECT_NEAR(look(engine, {3, 5.25}, 18, 0.5), 0.35 / std::sin(18 * 0.017453292519943295),
                kClose);
    EXPECT_EQ(look(engine, {3, 5.45}, 45, 0.5), 15.0);  // meets the top first
  });
}

// Tops of the map, ends and middles, and a little beside.
std::vector<Pose> poses_along_tops(const Map& map) {
  std::vector<Pose> poses;
  for (const Obstacle& obstacle : map.obstacles) {
    for (const Segment& segment : obstacle.segments) {
      if (segment.height_m > 0.0) continue;
      for (const double t : {-1.5, -0.25, 0.0, 0.5, 1.0, 1.2}) {
        for (const double beside_m : {0.0, 1e-4, -1e-4, 0.3, -0.3}) {
          const Point p = segment.a + t * (segment.b - segment.a);
          for (int turn = 0; turn < 8; ++turn) {
            poses.push_back({p.x, p.y + beside_m, Angle::from_degrees(45.0 * turn + 0.7)});
          }
        }
      }
    }
  }
  return poses;
}

// Of scans, the share of ranges that are not those of brute force.
double share_of_others(const ScanEngine& engine, const Map& map, const std::vector<Pose>& poses,
                       const LaserModel& laser) {
  std::vector<double> ranges(poses.size() * laser.rays), exact(ranges.size());
  engine.cast_all(poses, laser, ranges);
  BruteForceRayCaster(map).cast_all(poses, laser, exact);
  std::size_t others = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    others += std::abs(ranges[i] - exact[i]) > kClose ? 1 : 0;
  }
  return static_cast<double>(others) / static_cast<double>(ranges.size());
}

TEST(ScanEngineRules, StairsAloneAndTogetherAreThoseOfBruteForceOnTheLinesOfTheirTopsToo) {
  const Obstacle lower = test::stairs(1, 4, 6, 5, 5);
  const Obstacle upper = test::stairs_top_down(2, 2, 3, 4, 5);
  for (const Map& map : {test::map10({lower}), test::map10({lower, upper}),
                         test::map10({lower, test::wall(3, {{0, 3}, {10, 3}})})}) {
    const std::vector<Pose> poses = poses_along_tops(map);
    ASSERT_FALSE(poses.empty());
    on_each_instruction_set(map, [&](const ScanEngine& engine) {
      for (const double fov_deg : {180.0, 360.0}) {
        const LaserModel laser{131, fov_deg, 15.0, 0.5};
        EXPECT_LT(share_of_others(engine, map, poses, laser), 1e-3);  // rays along a top
        for (const Pose& pose : poses) {
          EXPECT_LT(share_of_others(engine, map, {pose}, laser), 0.02);
        }
      }
    });
  }
}

TEST(ScanEngineRules, ARampStopsRaysWhereItRisesToTheLaser) {
  // z = 0.08 / 0.9968 · (x − 2): 0.5 m at x = 8.23.
  const double x = 2.0 + 0.5 * 0.9968 / 0.08;
  on_each_instruction_set(test::map10({test::ramp(1, 2, 2, 10, 8)}), [&](const ScanEngine& engine) {
    EXPECT_NEAR(look(engine, {1, 5}, 0), x - 1.0, kClose);
    EXPECT_NEAR(look(engine, {5, 5}, 0), x - 5.0, kClose);
    EXPECT_EQ(look(engine, {9.5, 5}, 180), 15.0);   // from above
    EXPECT_EQ(look(engine, {9, 1}, 90), 15.0);      // from the side
    EXPECT_EQ(look(engine, {1, 1}, 0), 15.0);       // beside it
    EXPECT_EQ(look(engine, {1, 5}, 0, 0.7), 15.0);  // it does not get that high
  });
}

TEST(ScanEngineRules, ALaserOnAWallReadsNothingButZero) {
  on_each_instruction_set(test::map10({test::wall(1, {{5, 0}, {5, 10}})}),
                          [](const ScanEngine& engine) {
                            for (const double degrees : {0.0, 37.0, 90.0, 180.0}) {
                              EXPECT_NEAR(look(engine, {5, 3}, degrees), 0.0, kClose);
                            }
                          });
}

TEST(ScanEngineRules, ARayAlongAWallIsStoppedAtItsNearEnd) {
  on_each_instruction_set(test::map10({test::wall(1, {{5, 3}, {9, 3}})}),
                          [](const ScanEngine& engine) {
                            EXPECT_NEAR(look(engine, {2, 3}, 0), 3.0, kClose);
                            EXPECT_EQ(look(engine, {2, 3}, 180), 15.0);
                          });
}

TEST(ScanEngineRules, AFullTurnMeetsEveryWallOfARoom) {
  on_each_instruction_set(test::map10({test::hollow(1, 0, 0, 10, 10)}),
                          [](const ScanEngine& engine) {
                            const LaserModel laser{5, 360.0, 15.0, 0.5};
                            std::vector<double> ranges(5);
                            engine.cast({4, 3, Angle()}, laser, ranges);
                            const std::vector<double> expected{4, 3, 6, 7, 4};
                            for (std::size_t i = 0; i < 5; ++i) {
                              EXPECT_NEAR(ranges[i], expected[i], kClose) << i;
                            }
                          });
}

TEST(ScanEngineRules, NothingInReachReadsTheLongestRange) {
  on_each_instruction_set(test::map10({test::box(1, 2, 2, 3, 3)}), [](const ScanEngine& engine) {
    LaserModel laser;
    laser.max_range_m = 12.3;  // no single-precision number
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Pose& pose :
         {Pose{500, 0, Angle()}, Pose{1e12, -1e300, Angle()}, Pose{nan, 0, Angle()}}) {
      std::vector<double> ranges(laser.rays);
      engine.cast(pose, laser, ranges);
      EXPECT_EQ(ranges, std::vector<double>(laser.rays, 12.3));
    }
  });
}

TEST(ScanEngineRules, AnEmptyMapStopsNothing) {
  on_each_instruction_set(test::map10({}), [](const ScanEngine& engine) {
    EXPECT_EQ(look(engine, {1, 1}, 12), 15.0);
    EXPECT_EQ(engine.cast_ray({1, 1}, Angle(), 0.5, 7.0), 7.0);
  });
}

// Rays through the vertices of rings and around them, from within: none may get out.
TEST(ScanEngineRules, NoRayLeaksBetweenSegmentsThatShareAVertex) {
  std::vector<Point> points;
  for (int i = 0; i < 97; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 97.0;
    const double radius = 5.0 + 2.0 * std::sin(7.0 * angle);
    points.push_back({20.0 + radius * std::cos(angle), 20.0 + radius * std::sin(angle)});
  }
  const Map map = test::map({0, 40, 40, 0}, {test::ring(1, points)});
  on_each_instruction_set(map, [&](const ScanEngine& engine) {
    const LaserModel laser{3, 2e-5, 15.0, 0.5};  // at the vertex and 1e-5° beside it
    std::vector<Pose> poses;
    for (int i = 0; i < 40; ++i) {
      const Point from{19.0 + 0.05 * i, 20.3 - 0.017 * i};
      for (const Point p : points) {
        poses.push_back(
            {from.x, from.y, Angle::from_radians(std::atan2(p.y - from.y, p.x - from.x))});
      }
    }
    std::vector<double> ranges(poses.size() * laser.rays);
    engine.cast_all(poses, laser, ranges);
    for (const double range : ranges) ASSERT_LT(range, 9.0);
  });
}

}  // namespace
}  // namespace mapwright::navcore
