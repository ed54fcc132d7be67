#include "navcore/localization/particle_filter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "navcore/parallel.hpp"

namespace mapwright::navcore {
namespace {

constexpr std::size_t kGrain = 512;

// A scan that leaves less than this effective share is brought to bear in parts.
constexpr double kBearableShare = 0.2;
constexpr int kBisections = 12;

// Of the moves of a settled filter, the share that follows the spread of the place.
constexpr double kKinShare = 0.5;

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

// A compass reading carried along by what the encoders say.
HeadingPrior turned(const HeadingPrior& heading, const OdometryStep& step,
                    const OdometryNoise& noise) {
  const double before = noise.turn_per_turn * step.turn_before.wrapped().degrees();
  const double after = noise.turn_per_turn * step.turn_after.wrapped().degrees();
  const double way = Angle::from_radians(noise.turn_per_metre * step.distance_m).degrees();
  const double error = std::hypot(std::hypot(before, after), std::numbers::sqrt2 * way);
  return {heading.heading + step.turn_before + step.turn_after,
          std::hypot(heading.sigma_deg, error)};
}

}  // namespace

ParticleFilter::ParticleFilter(const ScanWeigher& weigher, const LaserModel& laser,
                               const FilterSettings& settings, std::uint64_t seed)
    : weigher_(&weigher),
      laser_(laser),
      settings_(settings),
      seed_(seed),
      size_limit_(settings.particles) {
  assert(settings.particles > 0);
}

Random ParticleFilter::stream(std::size_t particle) const {
  return Random(seed_, (epoch_ << 32U) + particle);
}

bool ParticleFilter::start_anywhere(const FreeSpace& space,
                                    const std::optional<HeadingPrior>& heading) {
  ++epoch_;
  space_ = &space;
  heading_ = heading;
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

void ParticleFilter::use(const ScanLook& look) {
  weigher_ = look.weigher;
  laser_ = look.laser;
  settings_.likelihood = look.likelihood;
  settings_.temper = look.temper;
  settings_.elsewhere = look.elsewhere;
  settings_.elsewhere_particles = look.elsewhere_particles;
  settings_.nearby_share = look.nearby_share;
  if (settings_.kld) settings_.kld->least = std::min(look.least_particles, settings_.particles);
}

void ParticleFilter::start_at(const Pose& pose, double sigma_m, double sigma_deg,
                              const FreeSpace* space) {
  ++epoch_;
  space_ = space;
  lost_ = false;
  std::vector<Pose> poses(settings_.particles);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Random random = stream(i);
    poses[i] = shaken(pose, sigma_m, sigma_deg, random);
  }
  particles_ = with_equal_weights(std::move(poses));
}

void ParticleFilter::take(ParticleSet particles, const FreeSpace* space) {
  ++epoch_;
  space_ = space;
  lost_ = false;
  extras_ = 0;
  particles_ = std::move(particles);
}

void ParticleFilter::move(const OdometryStep& step) {
  ++epoch_;
  if (heading_) heading_ = turned(*heading_, step, settings_.odometry);
  auto& poses = particles_.poses;
  const StepErrors errors = step_errors(step, settings_.odometry);
  parallel_for(poses.size(), kGrain, settings_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Random random = stream(i);
      poses[i] = moved(poses[i], perturbed_by(errors, step, random));
    }
  });
}

UpdateReport ParticleFilter::update(std::span<const double> scan) {
  UpdateReport report{particles_.size(), 0.0, false, false};
  if (lost_) {
    search(scan, report);
  } else {
    track(scan, report);
  }
  lost_ = false;
  sharpen(scan, report);
  return report;
}

// The first stage is blunt: beams far off cost little, so that a particle near the truth is told
// from others before it is at the truth. σm falls geometrically, the exponent rises as share^1.5.
ParticleFilter::Target ParticleFilter::search_target(std::size_t stage) const {
  const double share = static_cast<double>(stage) /
                       static_cast<double>(std::max<std::size_t>(1, settings_.first_stages));
  Target target{settings_.likelihood, settings_.temper * share * std::sqrt(share)};
  const double last_m = settings_.likelihood.sigma_m;
  target.likelihood.sigma_m = last_m * std::pow(settings_.first_sigma_m / last_m, 1.0 - share);
  return target;
}

// From each target to the next: importance weights, resampling, moves.
void ParticleFilter::search(std::span<const double> scan, UpdateReport& report) {
  factors_.assign(particles_.size(), 0.0);
  double last = 0.0;
  for (std::size_t stage = 1; stage <= std::max<std::size_t>(1, settings_.first_stages); ++stage) {
    const Target target = search_target(stage);
    bring_to_bear(target, last, scan, report);
    last = target.exponent;
  }
  size_limit_ = settings_.particles;
}

// What the particles are distributed by has the exponent `last` and the likelihood that `factors_`
// were computed by.
void ParticleFilter::bring_to_bear(const Target& target, double last, std::span<const double> scan,
                                   UpdateReport& report) {
  std::vector<double> factors = weigh(target, scan, particles_.poses);
  std::vector<double> gains(factors.size());
  for (std::size_t i = 0; i < gains.size(); ++i) {
    gains[i] = target.exponent * factors[i] - last * factors_[i];
  }
  factors_ = std::move(factors);
  report.contradicted |= !multiply_weights(particles_.weights, gains);
  if (report.effective_particles == 0.0) {
    report.effective_particles = effective_size(particles_.weights);
  }
  if (lost_) {
    const double keep = settings_.keep_effective * effective_size(particles_.weights);
    size_limit_ = std::clamp(static_cast<std::size_t>(keep), settings_.particles,
                             std::max(settings_.particles, particles_.size()));
  }
  renew(target, scan, report);
}

// On from the blunt look: σm falls geometrically, the exponent rises geometrically.
ParticleFilter::Target ParticleFilter::settled_target(std::size_t stage) const {
  const double share = static_cast<double>(stage) / static_cast<double>(settings_.settled_stages);
  const auto between = [&](double from, double to) { return from * std::pow(to / from, share); };
  Target target{settings_.likelihood, between(settings_.temper, settings_.settled_temper)};
  target.likelihood.sigma_m = between(settings_.likelihood.sigma_m, settings_.settled_sigma_m);
  return target;
}

void ParticleFilter::sharpen(std::span<const double> scan, UpdateReport& report) {
  if (settings_.settled_share > 1.0) return;
  sure_for_ = estimate().mode_share >= settings_.settled_share ? sure_for_ + 1 : 0;
  const bool settled = sure_for_ >= settings_.settled_after;
  size_limit_ =
      settled ? std::min(settings_.settled_particles, settings_.particles) : settings_.particles;
  if (!settled) return;
  sharp_ = true;
  double last = settings_.temper;
  for (std::size_t stage = 1; stage <= settings_.settled_stages; ++stage) {
    const Target target = settled_target(stage);
    bring_to_bear(target, last, scan, report);
    last = target.exponent;
  }
  sharp_ = false;
}

// The whole factor at once where enough particles survive it; otherwise a part that leaves enough,
// moves, the next part, and so on.
void ParticleFilter::track(std::span<const double> scan, UpdateReport& report) {
  Target target{settings_.likelihood, settings_.temper};
  const double whole = target.exponent;
  add_elsewhere();
  factors_ = weigh(target, scan, particles_.poses);
  double rest = whole;
  report.effective_particles = effective_size_after(rest);
  while (rest > 0.0) {
    const double part = bearable_part(rest, whole);
    report.contradicted |= !multiply_weights(particles_.weights, factors_, part);
    drop_elsewhere();
    rest = part < rest ? rest - part : 0.0;
    target.exponent = whole - rest;
    renew(target, scan, report);
  }
}

Pose ParticleFilter::somewhere_near(Random& random) const {
  const std::size_t i = low_variance_sample(particles_.weights, 1, random).front();
  Pose pose = shaken(particles_.poses[i], settings_.nearby_m, settings_.nearby_deg, random);
  if (random.uniform() < 0.5) pose.theta = draw_heading({}, random);
  return pose;
}

// The motion model is a mixture: odometry, near where it leads, or anywhere.
void ParticleFilter::add_elsewhere() {
  extras_ = 0;
  const std::size_t count = settings_.elsewhere_particles;
  if (space_ == nullptr || count == 0) return;
  ++epoch_;
  Random random = stream(0);
  const auto nearby =
      static_cast<std::size_t>(std::lround(settings_.nearby_share * static_cast<double>(count)));
  std::vector<Pose> extras;
  for (std::size_t i = 0; i < nearby; ++i) extras.push_back(somewhere_near(random));
  while (extras.size() < count) {
    const auto place = space_->sample(random);
    if (!place) break;
    extras.push_back({place->x, place->y, draw_heading(heading_, random)});
  }
  extras_ = extras.size();
  for (double& weight : particles_.weights) weight *= 1.0 - settings_.elsewhere;
  particles_.poses.insert(particles_.poses.end(), extras.begin(), extras.end());
  particles_.weights.resize(particles_.poses.size(),
                            settings_.elsewhere / static_cast<double>(count));
}

// Extra particles that the scan speaks against are not worth a resampling.
void ParticleFilter::drop_elsewhere() {
  if (extras_ == 0) return;
  const std::size_t count = particles_.size() - extras_;
  const auto first_extra = particles_.weights.begin() + static_cast<std::ptrdiff_t>(count);
  const double extra = std::accumulate(first_extra, particles_.weights.end(), 0.0);
  if (extra > settings_.elsewhere_worth) return;
  extras_ = 0;
  particles_.poses.resize(count);
  particles_.weights.resize(count);
  factors_.resize(count);
  for (double& weight : particles_.weights) weight /= 1.0 - extra;
}

double ParticleFilter::effective_size_after(double exponent) const {
  std::vector<double> weights = particles_.weights;
  multiply_weights(weights, factors_, exponent);
  return effective_size(weights);
}

// By bisection; not too small, so that it comes to an end. Without moves there is no point in
// parts.
double ParticleFilter::bearable_part(double rest, double whole) const {
  const double least = kBearableShare * static_cast<double>(particles_.size());
  if (settings_.sweeps == 0 || effective_size_after(rest) >= least) return rest;
  double low = 0.0, high = rest;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (effective_size_after(middle) >= least ? low : high) = middle;
  }
  return std::min(rest, std::max(low, whole * settings_.least_part));
}

void ParticleFilter::renew(const Target& target, std::span<const double> scan,
                           UpdateReport& report) {
  const double wanted = settings_.resample_below * static_cast<double>(particles_.size());
  if (particles_.size() > size_limit_ || extras_ > 0 ||
      effective_size(particles_.weights) < wanted) {
    resample();
    report.resampled = true;
  }
  if (!report.resampled) return;
  const std::size_t sweeps =
      lost_ ? std::max(settings_.sweeps, settings_.first_sweeps) : settings_.sweeps;
  for (std::size_t i = 0; i < sweeps; ++i) sweep(target, scan);
}

std::vector<double> ParticleFilter::weigh(const Target& target, std::span<const double> scan,
                                          std::span<const Pose> poses) const {
  std::vector<double> factors(poses.size());
  weigher_->weigh(scan, laser_, target.likelihood, poses, factors, settings_.threads);
  return factors;
}

// A first draw shows how many bins the weight is spread over.
std::size_t ParticleFilter::wanted_particles(Random& random) const {
  if (!settings_.kld) return size_limit_;
  std::vector<Pose> poses;
  for (const auto i : low_variance_sample(
           particles_.weights, std::min(settings_.particles, particles_.size()), random)) {
    poses.push_back(particles_.poses[i]);
  }
  const double size = kld_sample_size(occupied_bins(poses, *settings_.kld), *settings_.kld);
  const double most = static_cast<double>(settings_.particles);
  return std::max(settings_.kld->least, static_cast<std::size_t>(std::min(std::ceil(size), most)));
}

void ParticleFilter::resample() {
  ++epoch_;
  extras_ = 0;
  Random random = stream(0);
  const std::size_t count = wanted_particles(random);
  const Sample sample = settings_.place_power < 1.0
                            ? sample_by_place(particles_, count, settings_.place_power, random)
                            : sample_by_weight(particles_, count, random);
  ParticleSet drawn;
  std::vector<double> factors;
  for (const auto i : sample.indices) {
    drawn.poses.push_back(particles_.poses[i]);
    factors.push_back(factors_[i]);
  }
  drawn.weights = sample.weights;
  kin_ = sample.kin;
  particles_ = std::move(drawn);
  factors_ = std::move(factors);
}

Pose ParticleFilter::proposal(const Pose& pose, Random& random) const {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform());
  };
  const double scale = sharp_ ? settings_.settled_sigma_m / settings_.likelihood.sigma_m : 1.0;
  const double sigma_m = scale * between(settings_.shortest_move_m, settings_.longest_move_m);
  const double sigma_deg = scale * between(settings_.smallest_turn_deg, settings_.largest_turn_deg);
  return shaken(pose, sigma_m, sigma_deg, random);
}

// The difference of two others of the same place (differential evolution Markov chain: ter Braak
// 2006) has the length and the direction in which the place is uncertain.
Pose ParticleFilter::kin_proposal(std::size_t particle, Random& random) const {
  const auto [begin, end] = kin_[particle];
  const Pose& a = particles_.poses[begin + random.below(end - begin)];
  const Pose& b = particles_.poses[begin + random.below(end - begin)];
  const double scale = std::pow(10.0, -random.uniform());
  const Pose& pose = particles_.poses[particle];
  return {pose.x + scale * (a.x - b.x), pose.y + scale * (a.y - b.y),
          (pose.theta + scale * (a.theta - b.theta).wrapped()).wrapped()};
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
    const bool by_kin = sharp_ && kin_.size() == poses.size() && random.uniform() < kKinShare;
    proposals[i] = by_kin ? kin_proposal(i, random) : proposal(poses[i], random);
    thresholds[i] = random.uniform();
  }
  const std::vector<double> factors = weigh(target, scan, proposals);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (thresholds[i] >= std::exp(target.exponent * (factors[i] - factors_[i]))) continue;
    if (space_ != nullptr && !space_->is_free(proposals[i].position())) continue;
    poses[i] = proposals[i];
    factors_[i] = factors[i];
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
  settings.keep_effective = 1.0;
  settings.sweeps = 1;
  settings.first_sweeps = 2;
  settings.place_power = 0.5;
  settings.elsewhere = 1e-3;
  settings.elsewhere_particles = 3000;
  settings.elsewhere_worth = 1e-6;
  settings.settled_share = 0.99;
  return settings;
}

}  // namespace mapwright::navcore
