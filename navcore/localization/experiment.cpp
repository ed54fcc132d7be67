#include "navcore/localization/experiment.hpp"

#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <string>
#include <utility>

#include "navcore/localization/place_filter.hpp"
#include "navcore/localization/roaming.hpp"
#include "navcore/localization/truth_evidence.hpp"
#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

// Streams of one seed; the filter has a seed of its own.
enum Stream : std::uint64_t { kRobot, kSensors, kStart, kBelief };

/// The simulated robot: where it is, what it feels and sees.
class Robot {
 public:
  Robot(const FreeSpace& space, const RayCaster& caster, const ExperimentSettings& settings,
        const Pose& start, std::uint64_t seed)
      : space_(space),
        caster_(caster),
        settings_(settings),
        pose_(start),
        driver_(seed, kRobot),
        sensors_(seed, kSensors) {}

  const Pose& pose() const { return pose_; }
  const OdometryStep& last_step() const { return step_; }

  HeadingPrior compass() {
    const double sigma_deg = settings_.compass_error_deg;
    return {read_compass(pose_.theta, sigma_deg, sensors_), sigma_deg};
  }

  /// Drives on; what the encoders report.
  OdometryStep drive() {
    step_ = stroll(space_, pose_, settings_.step_m, settings_.robot_radius_m, driver_);
    pose_ = moved(pose_, step_);
    return perturbed(step_, settings_.filter.odometry, sensors_);
  }

  std::vector<double> scan() {
    return perceive(caster_, pose_, settings_.laser, settings_.laser_noise, sensors_);
  }

 private:
  const FreeSpace& space_;
  const RayCaster& caster_;
  const ExperimentSettings& settings_;
  Pose pose_;
  OdometryStep step_;
  Random driver_;
  Random sensors_;
};

// Where the filter is told that the robot starts.
std::optional<Pose> belief(const ExperimentSettings& settings, const Pose& truth,
                           std::uint64_t seed) {
  if (settings.initial_pose || !settings.start_known) return settings.initial_pose;
  Random random(seed, kBelief);
  const double dx = random.normal(0.0, settings.initial_sigma_m);
  const double dy = random.normal(0.0, settings.initial_sigma_m);
  const Angle turn = Angle::from_degrees(random.normal(0.0, settings.initial_sigma_deg));
  return Pose{truth.x + dx, truth.y + dy, (truth.theta + turn).wrapped()};
}

bool start_filter(PoseFilter& filter, const FreeSpace& space, Robot& robot,
                  const ExperimentSettings& settings, std::uint64_t seed, Journey& journey) {
  if (const auto pose = belief(settings, robot.pose(), seed)) {
    filter.start_at(*pose, settings.initial_sigma_m, settings.initial_sigma_deg);
    return true;
  }
  if (settings.heading_known) journey.compass = robot.compass();
  return filter.start_anywhere(space, journey.compass);
}

IterationRecord record(std::size_t n, const UpdateReport& update, const PoseFilter& filter,
                       const Robot& robot) {
  const Pose& truth = robot.pose();
  IterationRecord result;
  result.n = n;
  result.update = update;
  result.estimate = filter.estimate();
  result.true_pose = truth;
  result.step = robot.last_step();
  result.position_error_m = distance(result.estimate.pose.position(), truth.position());
  result.heading_error =
      Angle::from_radians(std::abs((result.estimate.pose.theta - truth.theta).wrapped().radians()));
  result.believes = believes_converged(result.estimate);
  result.claim = share_within(filter.particles(), result.estimate.pose, kRight_m, kRight_deg);
  result.truth_share = share_around(filter.particles(), truth);
  return result;
}

double truth_advantage(const ScanWeigher& weigher, const ExperimentSettings& settings,
                       const std::vector<double>& scan, const IterationRecord& iteration) {
  const std::array<Pose, 2> poses{iteration.true_pose, iteration.estimate.pose};
  std::array<double, 2> factors{};
  weigher.weigh(scan, settings.laser, settings.filter.likelihood, poses, factors, 1);
  return factors[0] - factors[1];
}

void judge(ExperimentRun& run, const Journey& journey, const ScanWeigher& weigher,
           const ExperimentSettings& settings) {
  if (run.iterations.empty() || run.iterations.back().is_right()) return;
  run.truth_evidence =
      evidence_for_truth(weigher, settings.laser, settings.filter.odometry, journey,
                         run.iterations.back().estimate.pose, kRight_m, kRight_deg, run.seed);
}

}  // namespace

bool believes_converged(const PoseEstimate& estimate) {
  return estimate.mode_share >= kConvergedShare && estimate.mode_spread_m <= kRight_m;
}

bool IterationRecord::is_right() const {
  return position_error_m <= kRight_m && heading_error.degrees() <= kRight_deg;
}

bool ExperimentRun::converged() const {
  return !iterations.empty() && iterations.back().believes && iterations.back().is_right();
}

bool ExperimentRun::mistaken() const {
  return !iterations.empty() && iterations.back().believes && !iterations.back().is_right();
}

double ExperimentRun::truth_advantage() const {
  double sum = 0.0;
  for (const auto& iteration : iterations) sum += iteration.truth_advantage;
  return sum;
}

std::optional<std::size_t> ExperimentRun::right_from() const {
  std::optional<std::size_t> from;
  for (const auto& iteration : iterations) {
    if (!iteration.is_right()) {
      from.reset();
    } else if (!from) {
      from = iteration.n;
    }
  }
  return from;
}

Result<ExperimentRun> run_experiment(const FreeSpace& space, const RayCaster& caster,
                                     const ScanWeigher& weigher, const ExperimentSettings& settings,
                                     const Pose& start, std::uint64_t seed) {
  if (!space.is_free(start.position())) {
    return usage_failure("the robot cannot stand at (" + std::to_string(start.x) + ", " +
                         std::to_string(start.y) + "): it is no free space");
  }
  Robot robot(space, caster, settings, start, seed);
  FilterSettings filter_settings = settings.filter;
  if (filter_settings.places) filter_settings.places->robot_radius_m = settings.robot_radius_m;
  const auto filter = make_filter(weigher, settings.laser, filter_settings, seed);
  Journey journey;
  if (!start_filter(*filter, space, robot, settings, seed, journey)) {
    return usage_failure("the map has no free space to search");
  }
  ExperimentRun run{seed, start, {}, {}};
  for (std::size_t n = 1; n <= settings.iterations; ++n) {
    journey.steps.push_back(n > 1 ? robot.drive() : OdometryStep());
    if (n > 1) filter->move(journey.steps.back());
    journey.true_poses.push_back(robot.pose());
    journey.scans.push_back(robot.scan());
    const std::vector<double>& scan = journey.scans.back();
    const UpdateReport update = filter->update(scan);
    run.iterations.push_back(record(n, update, *filter, robot));
    IterationRecord& last = run.iterations.back();
    last.truth_advantage = truth_advantage(weigher, settings, scan, last);
    if (!settings.keep_particles) continue;
    last.scan = scan;
    last.particles = filter->particles();
  }
  judge(run, journey, weigher, settings);
  return run;
}

Result<std::vector<ExperimentRun>> run_trials(const FreeSpace& space, const RayCaster& caster,
                                              const ScanWeigher& weigher,
                                              const ExperimentSettings& settings,
                                              std::size_t trials, std::uint64_t seed,
                                              unsigned threads, const Progress& progress) {
  std::vector<Result<ExperimentRun>> runs(trials);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(trials, 1, threads, [&](std::size_t i, std::size_t) {
    Random random(seed + i, kStart);
    const auto place = sample_roaming_place(space, settings.robot_radius_m, random);
    const Angle heading = Angle::from_radians(random.uniform(-std::numbers::pi, std::numbers::pi));
    runs[i] = place ? run_experiment(space, caster, weigher, settings,
                                     {place->x, place->y, heading}, seed + i)
                    : usage_failure("the robot fits nowhere in the map's free space");
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, trials);
  });
  std::vector<ExperimentRun> results;
  for (auto& run : runs) {
    if (!run) return tl::unexpected(run.error());
    results.push_back(*std::move(run));
  }
  return results;
}

}  // namespace mapwright::navcore
