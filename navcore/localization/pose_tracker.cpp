#include "navcore/localization/pose_tracker.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "navcore/localization/bearable_weights.hpp"

namespace mapwright::navcore {
namespace {

// Streams of a seed beside those of the filter, whose numbers are below 2^63.
constexpr std::uint64_t kStreams = std::uint64_t{1} << 63U;

// Drawing takes longer than casting where deviates are made anew for each scan.
constexpr std::size_t kDeviates = 4096;

// Proposals have some width even where all the weight is on one particle.
constexpr double kProposal_m = 0.001;
constexpr double kProposal_deg = 0.02;

}  // namespace

// The turns before and after only say which way it drove.
double way_of(const OdometryStep& step, double turn_m) {
  const double turn = std::abs((step.turn_before + step.turn_after).wrapped().radians());
  return std::abs(step.distance_m) + turn_m * turn;
}

PoseTracker::PoseTracker(const ScanWeigher& weigher, const TrackerSettings& settings,
                         std::uint64_t seed)
    : weigher_(&weigher), settings_(settings), seed_(seed) {
  Random random(seed_, kStreams + epoch_++);
  for (std::size_t i = 0; i < kDeviates; ++i) deviates_.push_back(PoseBelief::deviate(random));
}

void PoseTracker::start(const ParticleSet& particles) {
  particles_ = particles;
  way_m_ = 0.0;
}

void PoseTracker::move(const OdometryStep& step) {
  Random random(seed_, kStreams + epoch_++);
  const StepErrors errors = step_errors(step, settings_.odometry);
  for (Pose& pose : particles_.poses) {
    pose = moved(pose, perturbed_by(errors, step, random));
  }
  way_m_ += way_of(step, settings_.diffusion.turn_m);
}

std::size_t PoseTracker::wanted_particles() const {
  const std::size_t bins = occupied_bins(particles_.poses, settings_.kld);
  const double size = std::ceil(kld_sample_size(bins, settings_.kld));
  const double most = static_cast<double>(settings_.particles);
  return std::max(settings_.kld.least, static_cast<std::size_t>(std::min(size, most)));
}

PoseBelief PoseTracker::prior() const {
  const Diffusion& diffusion = settings_.diffusion;
  const double growth = std::sqrt(way_m_);
  return {particles_, std::hypot(diffusion.least_sigma_m, growth * diffusion.sigma_m),
          std::hypot(diffusion.least_sigma_deg, growth * diffusion.sigma_deg)};
}

// New particles, and minus the logarithms of the density they were drawn with.
std::vector<double> PoseTracker::draw(const PoseBelief& proposal, std::size_t count) {
  particles_.poses.clear();
  std::vector<double> log_weights;
  for (std::size_t i = 0; i < count; ++i) {
    const PoseBelief::Deviate& deviate = deviates_[next_];
    next_ = (next_ + 1) % kDeviates;
    particles_.poses.push_back(proposal.at(deviate));
    log_weights.push_back(-deviate.log_density);
  }
  return log_weights;
}

void PoseTracker::weigh(const TrackingStage& stage, const RecordedScan& scan, double trust,
                        const PoseBelief& prior, std::vector<double>& log_weights) {
  const SampledScan seen =
      sample_beams(scan, stage.beams, settings_.max_range_m, settings_.height_m);
  beams_ = seen.laser.rays;
  LikelihoodModel likelihood = settings_.likelihood;
  likelihood.sigma_m = stage.sigma_m;
  std::vector<double> factors(particles_.poses.size());
  TurnedWeigher(*weigher_, seen.heading)
      .weigh(seen.ranges, seen.laser, likelihood, particles_.poses, factors, 1);
  const double temper = trust * std::min(1.0, stage.evidence / static_cast<double>(beams_));
  for (std::size_t i = 0; i < factors.size(); ++i) {
    log_weights[i] += temper * factors[i] + prior.log_density(particles_.poses[i]);
  }
}

UpdateReport PoseTracker::update(const RecordedScan& scan, double trust) {
  assert(!settings_.stages.empty() && particles_.size() > 0);
  const std::size_t count = wanted_particles();
  const PoseBelief before = prior();
  way_m_ = 0.0;
  UpdateReport report{count, 0.0, false, true};
  PoseBelief proposal = before;
  for (const TrackingStage& stage : settings_.stages) {
    std::vector<double> log_weights = draw(proposal, count);
    weigh(stage, scan, trust, before, log_weights);
    particles_.weights = bearable_weights(log_weights);
    report.effective_particles = effective_size(particles_.weights);
    if (&stage != &settings_.stages.back())
      proposal = PoseBelief(particles_, kProposal_m, kProposal_deg);
  }
  return report;
}

}  // namespace mapwright::navcore
