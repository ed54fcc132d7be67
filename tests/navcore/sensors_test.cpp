#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "navcore/sensors/compass.hpp"
#include "navcore/sensors/laser_noise.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {
namespace {

struct Moments {
  double mean = 0.0, deviation = 0.0;
};

Moments moments(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

TEST(LaserNoise, IsGaussianOnEchoesAndLeavesEmptyBeamsAlone) {
  const LaserModel laser{40000, 180, 15, 0.5};
  std::vector<double> ranges(laser.rays, 7.0);
  ranges[0] = 15.0;
  Random random(1);
  add_noise(ranges, laser, {0.05, 0.0}, random);
  EXPECT_EQ(ranges[0], 15.0);
  ranges[0] = 7.0;
  const Moments m = moments(ranges);
  EXPECT_NEAR(m.mean, 7.0, 0.001);
  EXPECT_NEAR(m.deviation, 0.05, 0.001);
}

TEST(LaserNoise, StaysWithinTheLasersRange) {
  const LaserModel laser{1000, 180, 15, 0.5};
  Random random(2);
  for (const double truth : {0.01, 14.99}) {
    std::vector<double> ranges(laser.rays, truth);
    add_noise(ranges, laser, {0.5, 0.0}, random);
    for (const double range : ranges) {
      EXPECT_GE(range, 0.0);
      EXPECT_LE(range, 15.0);
    }
  }
}

TEST(LaserNoise, OccludesTheAskedShareOfBeamsAnywhereOnTheirWay) {
  const LaserModel laser{40000, 180, 15, 0.5};
  std::vector<double> ranges(laser.rays, 15.0);
  Random random(3);
  add_noise(ranges, laser, {0.0, 0.2}, random);
  std::vector<double> shortened;
  for (const double range : ranges) {
    if (range < 15.0) shortened.push_back(range);
  }
  EXPECT_NEAR(static_cast<double>(shortened.size()) / 40000, 0.2, 0.01);
  EXPECT_NEAR(moments(shortened).mean, 7.5, 0.2);
}

TEST(Compass, HasTheStatedError) {
  Random random(4);
  std::vector<double> errors;
  for (int i = 0; i < 20000; ++i) {
    const Angle reading = read_compass(Angle::from_degrees(179), 3.0, random);
    EXPECT_LE(std::abs(reading.degrees()), 180.0);
    errors.push_back((reading - Angle::from_degrees(179)).wrapped().degrees());
  }
  EXPECT_NEAR(moments(errors).mean, 0.0, 0.1);
  EXPECT_NEAR(moments(errors).deviation, 3.0, 0.05);
}

TEST(Odometry, LeadsFromOnePoseToTheOther) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const auto draw = [&] {
      return Pose{random.uniform(-9, 9), random.uniform(-9, 9),
                  Angle::from_radians(random.uniform(-3.14, 3.14))};
    };
    const Pose from = draw(), to = draw();
    const OdometryStep step = step_between(from, to);
    const Pose reached = moved(from, step);
    EXPECT_NEAR(distance(reached.position(), to.position()), 0.0, 1e-12);
    EXPECT_NEAR((reached.theta - to.theta).wrapped().radians(), 0.0, 1e-12);
    EXPECT_LE(std::abs(step.turn_before.degrees()), 90.0 + 1e-9) << "drives backwards instead";
  }
}

TEST(Odometry, OfATinyWayDoesNotTurnToFaceIt) {
  const OdometryStep step = step_between({0, 0, Angle()}, {-0.001, 0.002, Angle()});
  EXPECT_EQ(step.turn_before, Angle());
  EXPECT_DOUBLE_EQ(step.distance_m, -0.001);
  EXPECT_EQ(step.turn_after, Angle());
}

TEST(Angle, WrappedHasTheBitsOfTheRemainder) {
  const double pi = std::numbers::pi;
  for (const double angle : {0.1, -3.1, std::nextafter(pi, 0.0), -std::nextafter(pi, 0.0)}) {
    EXPECT_EQ(Angle::from_radians(angle).wrapped().radians(), std::remainder(angle, 2.0 * pi));
  }
  EXPECT_EQ(Angle::from_radians(pi).wrapped().radians(), pi);
  EXPECT_EQ(Angle::from_radians(-pi).wrapped().radians(), pi);
  EXPECT_NEAR(Angle::from_radians(3.5).wrapped().radians(), 3.5 - 2.0 * pi, 1e-12);
}

TEST(Odometry, ErrorsGrowWithTheMovement) {
  Random random(6);
  const OdometryNoise noise{0.1, 0.02, 0.05, 0.03};
  const OdometryStep step{Angle::from_radians(0.5), 2.0, Angle::from_radians(-0.3)};
  std::vector<double> before, way, after;
  for (int i = 0; i < 40000; ++i) {
    const OdometryStep felt = perturbed(step, noise, random);
    before.push_back(felt.turn_before.radians());
    way.push_back(felt.distance_m);
    after.push_back(felt.turn_after.radians());
  }
  EXPECT_NEAR(moments(before).mean, 0.5, 0.002);
  EXPECT_NEAR(moments(before).deviation, std::hypot(0.05, 0.04), 0.001);
  EXPECT_NEAR(moments(way).deviation, std::hypot(0.1, 0.024), 0.002);
  EXPECT_NEAR(moments(after).deviation, std::hypot(0.03, 0.04), 0.001);
  const OdometryStep still = perturbed({}, noise, random);
  EXPECT_EQ(still.distance_m, 0.0) << "a robot at rest feels nothing";
}

}  // namespace
}  // namespace mapwright::navcore
