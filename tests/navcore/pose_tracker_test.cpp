// Position tracking by importance sampling in stages.
#include "navcore/localization/pose_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/localizer.hpp"
#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::navcore {
namespace {

Pose pose_at(double x, double y, double deg) {
  return {x, y, Angle::from_degrees(deg)};
}

ParticleSet cloud(const Pose& middle, double sigma_m, double sigma_deg, std::size_t count) {
  Random random(3);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = random.normal(0.0, sigma_m);
    const double dy = random.normal(0.0, 2.0 * sigma_m);
    const Angle turn = Angle::from_degrees(random.normal(0.0, sigma_deg));
    poses.push_back({middle.x + dx, middle.y + dy, (middle.theta + turn).wrapped()});
  }
  return with_equal_weights(std::move(poses));
}

// Mean and standard deviations of what a belief draws, about a pose.
struct Spread {
  double x = 0.0, y = 0.0, deg = 0.0, sigma_x = 0.0, sigma_y = 0.0, sigma_deg = 0.0;
};

Spread spread_of(const PoseBelief& belief, const Pose& about, int count) {
  Random random(5);
  Spread s;
  for (int i = 0; i < count; ++i) {
    const Pose pose = belief.at(PoseBelief::deviate(random));
    const double dx = pose.x - about.x, dy = pose.y - about.y;
    const double turn = (pose.theta - about.theta).wrapped().degrees();
    s.x += dx / count;
    s.y += dy / count;
    s.deg += turn / count;
    s.sigma_x += dx * dx / count;
    s.sigma_y += dy * dy / count;
    s.sigma_deg += turn * turn / count;
  }
  s.sigma_x = std::sqrt(s.sigma_x - s.x * s.x);
  s.sigma_y = std::sqrt(s.sigma_y - s.y * s.y);
  s.sigma_deg = std::sqrt(s.sigma_deg - s.deg * s.deg);
  return s;
}

TEST(PoseBelief, HasTheMomentsOfItsParticlesTailIncluded) {
  const Pose middle = pose_at(10.0, -4.0, 179.5);  // headings on both sides of the cut
  const PoseBelief belief(cloud(middle, 0.2, 3.0, 20000), 1e-6, 1e-6);
  const Spread spread = spread_of(belief, middle, 40000);
  EXPECT_NEAR(spread.x, 0.0, 0.01);
  EXPECT_NEAR(spread.y, 0.0, 0.02);
  EXPECT_NEAR(spread.deg, 0.0, 0.15);
  EXPECT_NEAR(spread.sigma_x, 0.2, 0.01);
  EXPECT_NEAR(spread.sigma_y, 0.4, 0.02);
  EXPECT_NEAR(spread.sigma_deg, 3.0, 0.15);
}

TEST(PoseBelief, KnowsTheDensityOfWhatItDraws) {
  const PoseBelief belief(cloud(pose_at(1.0, 2.0, -40.0), 0.3, 5.0, 500), 0.01, 0.1);
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const auto deviate = PoseBelief::deviate(random);
    EXPECT_NEAR(belief.log_density(belief.at(deviate)), deviate.log_density, 1e-6);
  }
}

TEST(PoseBelief, OfOnePoseIsAsWideAsItIsMade) {
  const Pose pose = pose_at(0.0, 0.0, 10.0);
  const Spread spread = spread_of(PoseBelief(with_equal_weights({pose}), 0.1, 2.0), pose, 20000);
  // The tail makes it √1.8 times as wide.
  EXPECT_NEAR(spread.sigma_x, 0.1 * std::sqrt(1.8), 0.01);
  EXPECT_NEAR(spread.sigma_deg, 2.0 * std::sqrt(1.8), 0.2);
}

TEST(WayOf, CountsMetresAndTheTurnInTheEnd) {
  const auto step = [](double before_deg, double metres, double after_deg) {
    return OdometryStep{Angle::from_degrees(before_deg), metres, Angle::from_degrees(after_deg)};
  };
  EXPECT_NEAR(way_of(step(0.0, -2.0, 0.0), 1.0), 2.0, 1e-12);
  EXPECT_NEAR(way_of(step(80.0, 0.02, -80.0), 1.0), 0.02, 1e-12);  // sideways, not turned
  EXPECT_NEAR(way_of(step(0.0, 1.0, -90.0), 2.0), 1.0 + std::numbers::pi, 1e-12);
}

Map room() {
  Map map;
  map.border = {0.0, 12.0, 16.0, 0.0};
  std::int64_t id = 0;
  const auto wall = [&](Point a, Point b) {
    map.obstacles.push_back(
        {++id, ShapeType::kOpenPolygon, "wall", {{a, b, 3.0, InOut::kIndoor, "wall"}}});
  };
  wall({1, 1}, {15, 1});
  wall({15, 1}, {15, 11});
  wall({15, 11}, {1, 11});
  wall({1, 11}, {1, 1});
  wall({5, 4}, {7, 5});
  wall({10, 8}, {11, 6});
  return map;
}

class Tracking : public testing::Test {
 protected:
  // What a laser at the pose sees, with noise.
  RecordedScan scan_at(const Pose& pose, std::uint64_t seed) const {
    Random random(seed);
    RecordedScan scan;
    scan.fan = {181, Angle::from_degrees(-90.0), Angle::from_degrees(1.0)};
    scan.ranges = perceive(engine_, pose, {181, 180.0, 25.0, 0.5}, {0.02, 0.1}, random);
    return scan;
  }

  PoseTracker tracker(std::uint64_t seed) const {
    TrackerSettings settings = recorded_settings().tracker;
    settings.likelihood = recorded_settings().filter.likelihood;
    settings.odometry = recorded_settings().filter.odometry;
    return {engine_, settings, seed};
  }

  Map map_ = room();
  ScanEngine engine_{map_};
};

// Odometry says 0.5 m and 30°, and is off by a fifth of both.
TEST_F(Tracking, HoldsARobotWhoseOdometryIsBad) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    PoseTracker tracker = this->tracker(seed);
    tracker.start(cloud(pose_at(4.2, 2.9, 4.0), 0.2, 4.0, 2000));
    Pose pose = pose_at(4.0, 3.0, 0.0);
    double sum_m = 0.0;
    for (std::uint64_t i = 0; i < 12; ++i) {
      if (i > 0) {
        const OdometryStep step{Angle::from_degrees(i % 2 == 0 ? 30.0 : -30.0), 0.5, Angle()};
        pose = moved(pose, {1.2 * step.turn_before, 0.8 * step.distance_m, Angle()});
        tracker.move(step);
      }
      const UpdateReport report = tracker.update(scan_at(pose, 100 * seed + i));
      const PoseEstimate estimate = estimate_pose(tracker.particles());
      const double error_m = distance(estimate.pose.position(), pose.position());
      EXPECT_LT(error_m, 0.16) << "seed " << seed << " scan " << i;
      sum_m += error_m;
      EXPECT_LE(report.particles, 2000U);
      EXPECT_GT(report.effective_particles, 10.0);
    }
    EXPECT_LT(sum_m / 12, 0.06) << "seed " << seed;  // odometry is off by 0.1 m a scan
    EXPECT_LE(tracker.particles().size(), 400U);     // the first scan has taken more
  }
}

TEST_F(Tracking, ScansThatAreNotTrustedLeaveItWhereOdometrySays) {
  PoseTracker tracker = this->tracker(1);
  tracker.start(cloud(pose_at(4.0, 3.0, 0.0), 0.05, 1.0, 500));
  const RecordedScan elsewhere = scan_at(pose_at(4.15, 3.0, 0.0), 1);
  PoseTracker trusting = tracker;
  tracker.update(elsewhere, 0.0);
  trusting.update(elsewhere, 1.0);
  EXPECT_NEAR(estimate_pose(tracker.particles()).pose.x, 4.0, 0.03);
  EXPECT_NEAR(estimate_pose(trusting.particles()).pose.x, 4.15, 0.03);
}

TEST_F(Tracking, SameSeedSameParticles) {
  PoseTracker first = tracker(7), second = tracker(7), other = tracker(8);
  for (PoseTracker* tracker : {&first, &second, &other}) {
    tracker->start(cloud(pose_at(4.0, 3.0, 0.0), 0.1, 2.0, 300));
    tracker->move({Angle(), 0.3, Angle()});
    tracker->update(scan_at(pose_at(4.3, 3.0, 0.0), 1));
  }
  EXPECT_EQ(first.particles().poses, second.particles().poses);
  EXPECT_NE(first.particles().poses, other.particles().poses);
}

}  // namespace
}  // namespace mapwright::navcore
