// Derivatives of ranges against differences of brute force; the matrix and its bound.
#include "navcore/localizability/scan_information.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "navcore/rays/brute_force_ray_caster.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

using Ranges = std::vector<double>;

Pose shifted(const Pose& pose, int axis, double by) {
  return {pose.x + (axis == 0 ? by : 0.0), pose.y + (axis == 1 ? by : 0.0),
          Angle::from_radians(pose.theta.radians() + (axis == 2 ? by : 0.0))};
}

double component(const RangeGradient& g, int axis) {
  return axis == 0 ? g.by_x : axis == 1 ? g.by_y : g.by_theta;
}

struct Comparison {
  std::size_t compared = 0;    ///< derivatives
  std::size_t at_an_edge = 0;  ///< rays that jump from one wall to another between the differences
  double worst = 0.0;          ///< relative to 1 + |derivative|
  std::size_t other_ranges = 0;
  std::size_t echoes = 0;
};

// Fifth-order differences at two steps: where the two disagree, the ray has jumped.
void compare_ray(const std::array<std::array<Ranges, 4>, 3>& at, const RangeGradient& actual,
                 std::size_t ray, double h, Comparison& result) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto& r = at[static_cast<std::size_t>(axis)];
    const double wide = (r[3][ray] - r[0][ray]) / (4.0 * h);
    const double narrow = (r[2][ray] - r[1][ray]) / (2.0 * h);
    const double expected = (4.0 * narrow - wide) / 3.0;
    if (std::abs(wide - narrow) > 1e-4 * (1.0 + std::abs(expected))) {
      ++result.at_an_edge;
      continue;
    }
    ++result.compared;
    result.worst = std::max(
        result.worst, std::abs(component(actual, axis) - expected) / (1.0 + std::abs(expected)));
  }
}

void compare_pose(const Map& map, const GradientCaster& caster, const Pose& pose,
                  const LaserModel& laser, Comparison& result) {
  constexpr double kStep = 1e-5;
  const BruteForceRayCaster brute(map);
  Ranges expected(laser.rays);
  brute.cast(pose, laser, expected);
  std::array<std::array<Ranges, 4>, 3> at;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < 4; ++i) {
      constexpr std::array<double, 4> kSteps{-2.0, -1.0, 1.0, 2.0};
      Ranges& ranges = at[static_cast<std::size_t>(axis)][i];
      ranges.resize(laser.rays);
      brute.cast(shifted(pose, axis, kSteps[i] * kStep), laser, ranges);
    }
  }
  std::vector<RangeGradient> scan(laser.rays);
  caster.cast(pose, laser, scan);
  for (std::size_t ray = 0; ray < laser.rays; ++ray) {
    result.other_ranges += std::abs(scan[ray].range_m - expected[ray]) > 1e-9 ? 1 : 0;
    result.echoes += scan[ray].echo ? 1 : 0;
    EXPECT_EQ(scan[ray].echo, scan[ray].range_m < laser.max_range_m);
    compare_ray(at, scan[ray], ray, kStep, result);
  }
}

Comparison compare(const Map& map, const LaserModel& laser, int poses, std::uint64_t seed) {
  const GradientCaster caster(map);
  const Box area = map.border.box();
  Random random(seed);
  Comparison result;
  for (int i = 0; i < poses; ++i) {
    const Pose pose{random.uniform(area.min_x, area.max_x), random.uniform(area.min_y, area.max_y),
                    Angle::from_degrees(random.uniform(-180, 180))};
    compare_pose(map, caster, pose, laser, result);
  }
  return result;
}

void expect_derivatives(const Map& map, const LaserModel& laser, std::uint64_t seed) {
  const Comparison result = compare(map, laser, 60, seed);
  EXPECT_EQ(result.other_ranges, 0U);
  EXPECT_GT(result.echoes, 1000U);
  EXPECT_LT(result.worst, 1e-4);
  EXPECT_LT(static_cast<double>(result.at_an_edge), 0.01 * static_cast<double>(result.compared));
}

// Walls, curves, stairs from below and above, ramps: all that shapes.hpp can draw.
TEST(RangeGradients, AreTheDifferencesOfBruteForce) {
  expect_derivatives(test::cluttered_square(1), {131, 180, 15, 0.5}, 1);
  expect_derivatives(test::cluttered_square(2), {131, 360, 30, 0.15}, 2);
  expect_derivatives(test::rectilinear_town(), {61, 90, 25, 1.2}, 3);
}

TEST(RangeGradients, OfManyPosesAreThoseOfEach) {
  const Map map = test::cluttered_square(3);
  const GradientCaster caster(map);
  const LaserModel laser{61, 270, 12, 0.5};
  std::vector<Pose> poses;
  Random random(5);
  for (int i = 0; i < 600; ++i) {
    poses.push_back({0.01 * i, 20.0 + random.uniform(0.0, 1.0), Angle::from_degrees(i)});
  }
  std::vector<RangeGradient> all(poses.size() * laser.rays), one(laser.rays);
  caster.cast_all(poses, laser, all);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    caster.cast(poses[i], laser, one);
    for (std::size_t ray = 0; ray < laser.rays; ++ray) {
      ASSERT_EQ(all[i * laser.rays + ray].range_m, one[ray].range_m);
      ASSERT_EQ(all[i * laser.rays + ray].by_theta, one[ray].by_theta);
    }
  }
}

Map room(const std::vector<Obstacle>& obstacles) {
  return {{-100, 100, 100, -100}, obstacles};
}

// Along a wall without features nothing but the distance and the heading is known.
TEST(AccuracyBound, AlongAPlainWallThePositionIsUnknown) {
  const Map map = room({test::wall(1, {-50, 5}, {50, 5}, 3.0)});
  const GradientCaster caster(map);
  const LaserModel laser{131, 120, 30, 0.5};
  const PoseInformation information = scan_information(caster, {3, 1, Angle::from_degrees(90)},
                                                       laser, gaussian_range_information(0.05));
  const AccuracyBound bound = accuracy_bound(information);
  EXPECT_TRUE(std::isinf(bound.major_m));
  EXPECT_NEAR(std::abs(std::cos(bound.major_direction.radians())), 1.0, 1e-6);
  EXPECT_GT(bound.minor_m, 0.002);
  EXPECT_LT(bound.minor_m, 0.02);
  EXPECT_LT(bound.heading_rad, 0.01);
}

// One beam that looks straight at a wall knows the distance as well as the laser measures it, if
// the heading is given; with the heading unknown a second wall is needed.
TEST(AccuracyBound, OfFourBeamsInASquareRoomIsThatOfAverages) {
  const Map map = room({test::wall(1, {-5, 4}, {5, 4}, 3), test::wall(2, {-5, -4}, {5, -4}, 3),
                        test::wall(3, {5, -4}, {5, 4}, 3), test::wall(4, {-5, -4}, {-5, 4}, 3)});
  const GradientCaster caster(map);
  // Five rays: the first and the last both look straight back.
  const PoseInformation i =
      scan_information(caster, {0, 0, Angle()}, {5, 360, 30, 0.5}, gaussian_range_information(0.1));
  EXPECT_NEAR(i.xx, 3.0 / 0.01, 1e-6);
  EXPECT_NEAR(i.yy, 2.0 / 0.01, 1e-6);
  EXPECT_NEAR(i.xy, 0.0, 1e-6);
  EXPECT_NEAR(i.tt, 0.0, 1e-6);
  const AccuracyBound bound = accuracy_bound(i);
  EXPECT_NEAR(bound.major_m, 0.1 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(bound.minor_m, 0.1 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(std::abs(bound.major_direction.degrees()), 90.0, 1e-6);
  EXPECT_TRUE(std::isinf(bound.heading_rad));
}

// The bound is the inverse of the 3×3 matrix, however it is computed.
TEST(AccuracyBound, IsTheInverseOfTheMatrix) {
  const Map map = test::cluttered_square(1);
  const GradientCaster caster(map);
  Random random(9);
  const Box area = map.border.box();
  int checked = 0;
  for (int k = 0; k < 200; ++k) {
    const Pose pose{random.uniform(area.min_x, area.max_x), random.uniform(area.min_y, area.max_y),
                    Angle::from_degrees(random.uniform(-180, 180))};
    const PoseInformation i = scan_information(caster, pose, {131, 180, 15, 0.5}, 400.0);
    const double determinant = i.xx * (i.yy * i.tt - i.yt * i.yt) -
                               i.xy * (i.xy * i.tt - i.yt * i.xt) +
                               i.xt * (i.xy * i.yt - i.yy * i.xt);
    if (!(determinant > 1e-3 * i.xx * i.yy * i.tt)) continue;
    ++checked;
    const double cxx = (i.yy * i.tt - i.yt * i.yt) / determinant;
    const double cyy = (i.xx * i.tt - i.xt * i.xt) / determinant;
    const double cxy = (i.xt * i.yt - i.xy * i.tt) / determinant;
    const double ctt = (i.xx * i.yy - i.xy * i.xy) / determinant;
    const AccuracyBound bound = accuracy_bound(i);
    EXPECT_NEAR(bound.along_m(Angle()), std::sqrt(cxx), 1e-6 * std::sqrt(cxx));
    EXPECT_NEAR(bound.along_m(Angle::from_degrees(90)), std::sqrt(cyy), 1e-6 * std::sqrt(cyy));
    const double diagonal = std::sqrt(0.5 * (cxx + cyy) + cxy);
    EXPECT_NEAR(bound.along_m(Angle::from_degrees(45)), diagonal, 1e-6 * diagonal);
    EXPECT_NEAR(bound.heading_rad, std::sqrt(ctt), 1e-6 * std::sqrt(ctt));
    EXPECT_GE(bound.major_m, bound.minor_m);
  }
  EXPECT_GT(checked, 50);
}

TEST(AccuracyBound, NothingIsKnownWhereNothingEchoes) {
  const GradientCaster caster(room({}));
  const AccuracyBound bound =
      accuracy_bound(scan_information(caster, {0, 0, Angle()}, {131, 180, 15, 0.5}, 400.0));
  EXPECT_TRUE(std::isinf(bound.major_m));
  EXPECT_TRUE(std::isinf(bound.minor_m));
  EXPECT_TRUE(std::isinf(bound.heading_rad));
}

}  // namespace
}  // namespace mapwright::navcore
