#include "navcore/localization/truth_evidence.hpp"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "navcore/localization/place_filter.hpp"

namespace mapwright::navcore {
namespace {

constexpr std::uint64_t kStream = std::uint64_t{1} << 61U;

// Around both starts: enough for the other place to be met as well as it can be.
constexpr std::size_t kParticles = 2000;
constexpr double kStart_m = 0.5;
constexpr double kStart_deg = 5.0;

constexpr std::size_t kLeastParticles = 300;  // of each cell, later

FilterSettings judging_settings(const OdometryNoise& odometry) {
  FilterSettings settings = robust_settings();
  settings.elsewhere_particles = 0;
  settings.particles = kParticles;
  settings.odometry = odometry;
  settings.places->least_particles = kLeastParticles;
  settings.places->settled_share = 2.0;
  return settings;
}

void add_cloud(const Pose& middle, const std::optional<HeadingPrior>& compass, Random& random,
               ParticleSet& cloud) {
  for (std::size_t i = 0; i < kParticles; ++i) {
    const double x = middle.x + random.normal(0.0, kStart_m);
    const double y = middle.y + random.normal(0.0, kStart_m);
    const Angle turn = Angle::from_degrees(random.normal(0.0, kStart_deg));
    cloud.poses.push_back({x, y, (middle.theta + turn).wrapped()});
    cloud.weights.push_back(std::exp(log_density(compass, cloud.poses.back().theta)));
  }
}

// The compass may speak against one of them, as it did to the filter.
ParticleSet both_starts(const Journey& journey, const Pose& estimate, std::uint64_t seed) {
  Random random(seed, kStream);
  const Pose& start = journey.true_poses.front();
  ParticleSet cloud;
  add_cloud(start, journey.compass, random, cloud);
  add_cloud(carried_along(start, journey.true_poses.back(), estimate), journey.compass, random,
            cloud);
  const double sum = std::accumulate(cloud.weights.begin(), cloud.weights.end(), 0.0);
  for (double& weight : cloud.weights) weight /= sum;
  return cloud;
}

}  // namespace

Pose carried_along(const Pose& pose, const Pose& from, const Pose& to) {
  const Angle turn = to.theta - from.theta;
  const double c = std::cos(turn.radians()), s = std::sin(turn.radians());
  const Point off = pose.position() - from.position();
  return {to.x + c * off.x - s * off.y, to.y + s * off.x + c * off.y,
          (pose.theta + turn).wrapped()};
}

double evidence_for_truth(const ScanWeigher& weigher, const LaserModel& laser,
                          const OdometryNoise& odometry, const Journey& journey,
                          const Pose& estimate, double right_m, double right_deg,
                          std::uint64_t seed) {
  assert(!journey.scans.empty() && journey.true_poses.size() == journey.scans.size());
  PlaceFilter judge(weigher, laser, judging_settings(odometry), seed);
  judge.take(both_starts(journey, estimate, seed));
  for (std::size_t i = 0; i < journey.scans.size(); ++i) {
    if (i > 0) judge.move(journey.steps[i]);
    judge.update(journey.scans[i]);
  }
  return share_within(judge.particles(), journey.true_poses.back(), right_m, right_deg);
}

}  // namespace mapwright::navcore
