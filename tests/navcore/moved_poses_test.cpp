// Where a step leads from what was known.
#include "navcore/localization/moved_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/place_filter.hpp"
#include "navcore/sensors/laser_noise.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::navcore {
namespace {

using test::wall;

Pose pose_at(double x, double y, double deg) {
  return {x, y, Angle::from_degrees(deg)};
}

OdometryStep step_of(double before_deg, double distance_m, double after_deg) {
  return {Angle::from_degrees(before_deg), distance_m, Angle::from_degrees(after_deg)};
}

ParticleSet stretch(double from_x, double to_x, int count) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    // Across and in heading there are a few values, in no order with the place along.
    const double off = static_cast<double>(i * 7 % 11 - 5) / 5.0;
    const double turn = static_cast<double>(i * 5 % 13 - 6) / 6.0;
    poses.push_back(pose_at(from_x + share * (to_x - from_x), 0.02 * off, 0.5 * turn));
  }
  return with_equal_weights(std::move(poses));
}

TEST(MovedPoses, AreADensity) {
  ParticleSet from = with_equal_weights({pose_at(0, 0, 170), pose_at(0.4, 0.1, -175)});
  from.weights = {0.7, 0.3};
  const OdometryStep step = step_of(20.0, 0.5, -30.0);
  const MovedPoses poses(from, step, {0.2, 0.1, 0.2, 0.1});
  const Pose middle = moved(pose_at(0.2, 0.05, 177), step);
  Random random(1);
  const double half_m = 0.8, half_rad = Angle::from_degrees(40.0).radians();
  const int kDraws = 2000000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    sum += std::exp(poses.log_density(
        {middle.x + random.uniform(-half_m, half_m), middle.y + random.uniform(-half_m, half_m),
         (middle.theta + Angle::from_radians(random.uniform(-half_rad, half_rad))).wrapped()}));
  }
  EXPECT_NEAR(sum / kDraws * 8.0 * half_m * half_m * half_rad, 1.0, 0.05);
}

// The logarithm of a normal density in three dimensions lies 3/2 below its peak in the mean.
TEST(MovedPoses, AreSpreadAsTheErrorsOfTheStep) {
  for (const OdometryStep& step :
       {step_of(0.0, 1.0, 0.0), step_of(40.0, 1.0, 0.0), step_of(-5.0, -2.0, 60.0)}) {
    const Pose start = pose_at(3.0, 1.0, 25.0);
    const MovedPoses poses(with_equal_weights({start}), step, {});
    const double peak = poses.log_density(moved(start, step));
    Random random(2);
    const int kDraws = 20000;
    double below = 0.0;
    for (int i = 0; i < kDraws; ++i) {
      below += peak - poses.log_density(moved(start, perturbed(step, {}, random)));
    }
    EXPECT_NEAR(below / kDraws, 1.5, 0.1);
  }
}

// A robot may be where none of the few poses led: six standard deviations off is a tenth, spread
// over 27 times the volume, of e^(-6²/18), and not e^-18 of the peak.
TEST(MovedPoses, LeaveAChanceToWhatIsFarOff) {
  const Pose start = pose_at(3.0, 1.0, 25.0);
  const OdometryStep step = step_of(0.0, 1.0, 0.0);
  const MovedPoses poses(with_equal_weights({start}), step, {});
  const double deviation_m = step_errors(step, {}).distance_m;
  const auto density_at = [&](double deviations) {
    return poses.log_density(moved(start, step_of(0.0, 1.0 + deviations * deviation_m, 0.0)));
  };
  EXPECT_NEAR(density_at(2.0) - density_at(0.0), -2.0, 0.1);
  EXPECT_NEAR(density_at(6.0) - density_at(0.0), std::log(0.1 / 0.9 / 27.0) - 2.0, 0.1);
}

// A normal distribution for each of two stretches of a wall makes a hill of each, with a valley
// between them a fifth as high.
TEST(MovedPoses, OfTwoStretchesOfAWallKnowNothingOfTheirBorder) {
  const OdometryStep ahead = step_of(0.0, 1.0, 0.0);
  const MovedPoses left(stretch(0.0, 1.0, 120), ahead, {});
  const MovedPoses right(stretch(1.0, 2.0, 120), ahead, {});
  const auto density = [&](double x) {
    return std::exp(left.log_density(pose_at(x + 1.0, 0, 0))) +
           std::exp(right.log_density(pose_at(x + 1.0, 0, 0)));
  };
  double whole = 0.0;
  for (int i = 0; i < 100; ++i) whole += density(0.5 + 0.01 * (i + 0.5)) / 100.0;
  for (int i = 0; i < 20; ++i) {
    double near = 0.0;
    for (int k = 0; k < 5; ++k) near += density(0.5 + 0.05 * i + 0.01 * (k + 0.5)) / 5.0;
    EXPECT_NEAR(near / whole, 1.0, 0.3) << "at " << 0.5 + 0.05 * i;
  }
}

TEST(MovedPoses, KnowWhereTheyCameFrom) {
  const ParticleSet from = with_equal_weights({pose_at(0, 0, 0), pose_at(0.3, 0, 0)});
  const MovedPoses poses(from, step_of(90.0, 1.0, 0.0), {});
  EXPECT_EQ(poses.origin_of(pose_at(0.05, 1.0, 90.0)).x, 0.0);
  EXPECT_EQ(poses.origin_of(pose_at(0.25, 1.0, 90.0)).x, 0.3);
}

// Two walls that are the same, one half a cell of places further on than the other.
class BareWalls : public testing::Test {
 protected:
  static constexpr double kNext_m = 40.5;

  static Map bare_walls() {
    Map map{{0, 12, 90, 0}, {}};
    for (const double left : {2.0, 2.0 + kNext_m}) {
      map.obstacles.push_back(
          wall(static_cast<std::int64_t>(map.obstacles.size()) + 1, {left + 30, 5}, {left, 5}, 2));
    }
    return map;
  }

  // The robot is somewhere along a stretch of either, and drives on until it sees the end.
  double share_of_the_truth(double start_x, std::uint64_t seed) const {
    FilterSettings settings = robust_settings();
    settings.elsewhere_particles = 0;
    settings.particles = 3000;
    PlaceFilter filter(engine_, laser_, settings, seed);
    Random random(seed);
    std::vector<Pose> poses;
    for (int i = 0; i < 6000; ++i) {
      const double x = start_x + random.uniform(-3.0, 3.0) + (i % 2 == 0 ? 0.0 : kNext_m);
      poses.push_back(pose_at(x, random.normal(3.0, 0.05), random.normal(0.0, 1.0)));
    }
    filter.take(with_equal_weights(std::move(poses)));
    Pose truth = pose_at(start_x, 3.0, 0.0);
    const OdometryStep step{Angle(), 1.0, Angle()};
    for (int i = 0; i < 5; ++i) {
      if (i > 0) filter.move(perturbed(step, settings.odometry, random));
      if (i > 0) truth = moved(truth, step);
      filter.update(perceive(engine_, truth, laser_, {}, random));
    }
    return share_around(filter.particles(), truth);
  }

  Map map_ = bare_walls();
  ScanEngine engine_{map_};
  LaserModel laser_{61, 180.0, 6.0, 0.5};
};

TEST_F(BareWalls, ThatAreAlikeKeepTheirHalves) {
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const double share = share_of_the_truth(24.0 + 0.1 * static_cast<double>(seed), seed);
    const double odds = std::log(share / (1.0 - share));
    squares += odds * odds / 12.0;
  }
  EXPECT_LT(std::sqrt(squares), 0.7) << "standard deviation of the logarithm of the odds";
}

}  // namespace
}  // namespace mapwright::navcore
