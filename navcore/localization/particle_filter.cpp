#include "navcore/localization/particle_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

constexpr std::size_t kGrain = 512;

Pose shaken(const Pose& pose, double sigma_m, double sigma_deg, Random& random) {
  const double dx = random.normal(0.0, sigma_m);
  const double dy = random.normal(0.0, sigma_m);
  const Angle turn = Angle::from_degrees(random.normal(0.0, sigma_deg));
  return {pose.x + dx, pose.y + dy, (pose.theta + turn).wrapped()};
}

Angle draw_heading(const std::optional<HeadingPrior>& prior, Random& random) {
  if (!prior) return Angle::from_radians(random.uniform(-std::numbers::pi, std::numbers::pi));
  return (prior->heading + Angle::from_degrees(random.normal(0.0, prior->sigma_deg))).wrapped();
}

}  // namespace

ParticleFilter::ParticleFilter(const ScanWeigher& weigher, const LaserModel& laser,
                               const FilterSettings& settings, std::uint64_t seed)
    : weigher_(&weigher), laser_(laser), settings_(settings), seed_(seed) {
  assert(settings.particles > 0);
}

Random ParticleFilter::stream(std::size_t particle) const {
  return Random(seed_, (epoch_ << 32U) + particle);
}

bool ParticleFilter::start_anywhere(const FreeSpace& space,
                                    const std::optional<HeadingPrior>& heading) {
  ++epoch_;
  space_ = &space;
  lost_ = true;
  Random random = stream(0);
  std::vector<Pose> poses(std::max(settings_.first_particles, settings_.particles));
  for (Pose& pose : poses) {
    const auto place = space.sample(random);
    if (!place) return false;
    pose = {place->x, place->y, draw_heading(heading, random)};
  }
  particles_ = with_equal_weights(std::move(poses));
  return true;
}

void ParticleFilter::start_at(const Pose& pose, double sigma_m, double sigma_deg) {
  ++epoch_;
  lost_ = false;
  std::vector<Pose> poses(settings_.particles);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Random random = stream(i);
    poses[i] = shaken(pose, sigma_m, sigma_deg, random);
  }
  particles_ = with_equal_weights(std::move(poses));
}

void ParticleFilter::move(const OdometryStep& step) {
  ++epoch_;
  auto& poses = particles_.poses;
  parallel_for(poses.size(), kGrain, settings_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random random = stream(i);
      poses[i] = moved(poses[i], perturbed(step, settings_.odometry, random));
    }
  });
}

// The first stage is blunt: beams far off cost little, so that a particle near the truth is told
// from others before it is at the truth. σm falls geometrically, the exponent rises as share^1.5.
ParticleFilter::Target ParticleFilter::target(std::size_t stage, std::size_t stages) const {
  Target result{settings_.likelihood, settings_.temper};
  if (stages <= 1) return result;
  const double share = static_cast<double>(stage) / static_cast<double>(stages);
  const double last_m = settings_.likelihood.sigma_m;
  result.likelihood.sigma_m = last_m * std::pow(settings_.first_sigma_m / last_m, 1.0 - share);
  result.temper *= share * std::sqrt(share);
  return result;
}

std::vector<double> ParticleFilter::log_values(const Target& target, std::span<const double> scan,
                                               std::span<const Pose> poses) const {
  std::vector<double> values(poses.size());
  weigher_->weigh(scan, laser_, target.likelihood, poses, values, settings_.threads);
  for (double& value : values) value *= target.temper;
  return values;
}

UpdateReport ParticleFilter::update(std::span<const double> scan) {
  const std::size_t stages = lost_ ? settings_.first_stages : 1;
  lost_ = false;
  UpdateReport report{particles_.size(), 0.0, false, false};
  values_.assign(particles_.size(), 0.0);
  for (std::size_t stage = 1; stage <= stages; ++stage) {
    approach(target(stage, stages), scan, report);
  }
  return report;
}

// Importance weights from the last target to this one, then resampling and moves.
void ParticleFilter::approach(const Target& target, std::span<const double> scan,
                              UpdateReport& report) {
  std::vector<double> values = log_values(target, scan, particles_.poses);
  std::vector<double> gains(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) gains[i] = values[i] - values_[i];
  values_ = std::move(values);
  if (!multiply_weights(particles_.weights, gains)) report.contradicted = true;
  report.effective_particles = effective_size(particles_.weights);
  const bool too_many = particles_.size() != settings_.particles;
  const double wanted = settings_.resample_below * static_cast<double>(particles_.size());
  if (too_many || report.effective_particles < wanted) {
    resample();
    report.resampled = true;
  }
  if (!report.resampled) return;
  for (std::size_t i = 0; i < settings_.sweeps; ++i) sweep(target, scan);
}

void ParticleFilter::resample() {
  ++epoch_;
  Random random = stream(0);
  std::vector<Pose> poses;
  std::vector<double> values;
  poses.reserve(settings_.particles);
  values.reserve(settings_.particles);
  for (const auto i : low_variance_sample(particles_.weights, settings_.particles, random)) {
    poses.push_back(particles_.poses[i]);
    values.push_back(values_[i]);
  }
  particles_ = with_equal_weights(std::move(poses));
  values_ = std::move(values);
}

Pose ParticleFilter::proposal(const Pose& pose, Random& random) const {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform());
  };
  const double sigma_m = between(settings_.shortest_move_m, settings_.longest_move_m);
  const double sigma_deg = between(settings_.smallest_turn_deg, settings_.largest_turn_deg);
  return shaken(pose, sigma_m, sigma_deg, random);
}

// Metropolis: a symmetric proposal, accepted with the ratio of the scan's factors. The prior is
// taken for level over the length of a move; it ends where free space does.
void ParticleFilter::sweep(const Target& target, std::span<const double> scan) {
  ++epoch_;
  auto& poses = particles_.poses;
  std::vector<Pose> proposals(poses.size());
  std::vector<double> thresholds(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Random random = stream(i);
    proposals[i] = proposal(poses[i], random);
    thresholds[i] = random.uniform();
  }
  const std::vector<double> values = log_values(target, scan, proposals);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (thresholds[i] >= std::exp(values[i] - values_[i])) continue;
    if (space_ != nullptr && !space_->is_free(proposals[i].position())) continue;
    poses[i] = proposals[i];
    values_[i] = values[i];
  }
}

FilterSettings report_settings() {
  FilterSettings settings;
  settings.first_particles = settings.particles;
  settings.likelihood = report_likelihood();
  return settings;
}

FilterSettings robust_settings() {
  FilterSettings settings;
  settings.likelihood = {LikelihoodKind::kRobust, 1.0, 1.0, 0.5, 0.15};
  settings.temper = 0.3;
  settings.first_stages = 8;
  settings.first_sigma_m = 0.75;
  settings.sweeps = 1;
  return settings;
}

}  // namespace mapwright::navcore
