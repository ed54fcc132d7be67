#include "navcore/localization/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "navcore/localization/experiment.hpp"

namespace mapwright::navcore {
namespace {

// What the tracker has in common with the filter.
TrackerSettings tracker_settings(const RecordedSettings& settings) {
  TrackerSettings tracker = settings.tracker;
  tracker.likelihood = settings.filter.likelihood;
  tracker.odometry = settings.filter.odometry;
  tracker.max_range_m = settings.max_range_m;
  tracker.height_m = settings.height_m;
  return tracker;
}

bool is_one_mode(const Pose& a, const Pose& b) {
  const double turn_deg = (a.theta - b.theta).wrapped().degrees();
  return distance(a.position(), b.position()) <= kModeRadius_m &&
         std::abs(turn_deg) <= kModeHeading_deg;
}

// Those of the mode that the pose is the middle of.
ParticleSet around(const ParticleSet& particles, const Pose& pose) {
  ParticleSet mode;
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose& p = particles.poses[i];
    if (!is_one_mode(p, pose)) continue;
    mode.poses.push_back(p);
    mode.weights.push_back(particles.weights[i]);
    sum += particles.weights[i];
  }
  if (!(sum > 0.0)) return with_equal_weights({pose});
  for (double& weight : mode.weights) weight /= sum;
  return mode;
}

bool are_apart(const Pose& a, const Pose& b) {
  const Angle turn = (a.theta - b.theta).wrapped();
  return distance(a.position(), b.position()) > kRight_m || std::abs(turn.degrees()) > kRight_deg;
}

}  // namespace

Localizer::Localizer(const FreeSpace& space, const ScanWeigher& weigher,
                     const RecordedSettings& settings, std::uint64_t seed)
    : space_(space),
      settings_(settings),
      weigher_(weigher),
      turned_(weigher, Angle()),
      filter_(turned_, {}, settings.filter, seed),
      tracker_(weigher, tracker_settings(settings), seed),
      quality_(settings.quality),
      agreement_(settings.agreement_decay),
      there_(settings.agreement_decay) {}

bool Localizer::start() {
  if (!settings_.initial_pose) return filter_.start_anywhere(space_, {});
  filter_.start_at(*settings_.initial_pose, settings_.initial_sigma_m, settings_.initial_sigma_deg,
                   &space_);
  if (has_tracker()) {
    PoseEstimate known;
    known.pose = *settings_.initial_pose;
    follow(known);
  }
  return true;
}

void Localizer::drive(const OdometryStep& step) {
  way_m_ += way_of(step, settings_.tracker.diffusion.turn_m);
  expected_ = moved(expected_, step);
  if (tracking_) tracker_.move(step);
  if (former_) former_->tracker.move(step);
  if (!tracking_ || challenged_) filter_.move(step);
}

double Localizer::news_since_last_scan() {
  const double way_m = std::exchange(way_m_, 0.0);
  return std::clamp(way_m / settings_.news_m, settings_.least_news, 1.0);
}

LocalizerLook Localizer::look(const RecordedScan& scan) {
  LocalizerLook result;
  result.tracked = tracking_;
  tracking_ ? track(scan, result) : search(scan, result);
  if (settings_.keep_particles) {
    result.seen = sample(scan, result.beams);
    result.particles = particles();
  }
  return result;
}

const ParticleSet& Localizer::particles() const {
  return tracking_ ? tracker_.particles() : filter_.particles();
}

void Localizer::search(const RecordedScan& scan, LocalizerLook& result) {
  const double news = news_since_last_scan();
  result.update = update_filter(scan, settings_.search);
  result.beams = turned_beams_;
  result.estimate = filter_.estimate();
  result.believes = believes_converged(result.estimate);
  const bool stays = result.believes && is_one_mode(expected_, result.estimate.pose);
  sure_for_ = stays ? sure_for_ + news : 0.0;
  expected_ = result.estimate.pose;
  agreement_.add(agreement(log_fit(scan, result.estimate.pose)), news);
  const bool poor = agreement_.mean() < settings_.search_agreement;
  poor_for_ = poor ? poor_for_ + news : 0.0;
  if (!has_tracker()) return;
  if (poor_for_ >= settings_.search_patience) {
    begin_search_anew();
  } else if (!poor && sure_for_ >= settings_.confirmation) {
    follow(result.estimate);
  }
}

void Localizer::track(const RecordedScan& scan, LocalizerLook& result) {
  result.update = tracker_.update(scan, 1.0 - quality_.share_lost());
  result.beams = tracker_.beams();
  result.estimate = estimate_pose(tracker_.particles());
  const double news = news_since_last_scan();
  const double fit = log_fit(scan, result.estimate.pose);
  quality_.add(std::exp(fit), lost_for_ > 0.0, news);
  agreement_.add(agreement(fit), news);
  if (former_ && is_regretted(scan, fit, news, result)) return;
  const bool lost = is_doubtful();
  lost_for_ = lost ? lost_for_ + news : 0.0;
  result.doubted = lost;
  result.believes = !lost && believes_converged(result.estimate);
  if (lost) {
    challenge(scan, news, result);
  } else {
    challenged_ = false;
  }
}

bool Localizer::is_doubtful() const {
  if (agreement_.scans() >= 3.0 && agreement_.mean() < settings_.least_agreement) return true;
  return quality_.share_lost() >= settings_.lost_share &&
         agreement_.mean() < settings_.content_agreement;
}

void Localizer::begin_search_anew() {
  filter_.start_anywhere(space_, {});
  agreement_.begin_anew();
  sure_for_ = poor_for_ = 0.0;
}

// The filter begins where the tracker is, looks nearby, then elsewhere, at last everywhere.
void Localizer::challenge(const RecordedScan& scan, double news, LocalizerLook& result) {
  if (!challenged_) {
    filter_.take(tracker_.particles(), &space_);
    advantage_ = 0.0;
    there_.begin_anew();
    everywhere_ = false;
    search_after_ = settings_.patience;
  }
  challenged_ = true;
  if (lost_for_ > search_after_) {
    everywhere_ = filter_.start_anywhere(space_, {});
    search_after_ = 2.0 * lost_for_;
    advantage_ = 0.0;
  }
  const UpdateReport update =
      update_filter(scan, everywhere_ ? settings_.search : settings_.recover);
  result.update.particles += update.particles;
  weigh_challenger(scan, filter_.estimate(), news, result);
}

// One place against the other, by all the scans since they are two.
void Localizer::weigh_challenger(const RecordedScan& scan, const PoseEstimate& estimate,
                                 double news, LocalizerLook& result) {
  if (!believes_converged(estimate) || !are_apart(estimate.pose, result.estimate.pose)) {
    advantage_ = 0.0;
    there_.begin_anew();
    return;
  }
  const double there = log_fit(scan, estimate.pose);
  there_.add(agreement(there), news);
  const double better = there - log_fit(scan, result.estimate.pose);
  advantage_ = std::max(0.0, advantage_ + news * settings_.recover.evidence * better);
  if (advantage_ < settings_.conviction || there_.mean() < settings_.content_agreement ||
      there_.scans() < settings_.conviction_scans) {
    return;
  }
  give_way(estimate, there);
  result.estimate = estimate;
}

void Localizer::give_way(const PoseEstimate& estimate, double log_fit) {
  if (settings_.regret_scans > 0.0) former_ = Former{tracker_};
  follow(estimate);
  agreement_ = there_;
  quality_.begin_anew(std::exp(log_fit));
}

// A gap of the map may have made the other place look better.
bool Localizer::is_regretted(const RecordedScan& scan, double fit, double news,
                             LocalizerLook& result) {
  result.update.particles += former_->tracker.update(scan).particles;
  const PoseEstimate estimate = estimate_pose(former_->tracker.particles());
  former_->scans += news;
  if (former_->scans > settings_.regret_scans || !are_apart(estimate.pose, result.estimate.pose)) {
    former_.reset();
    return false;
  }
  const double there = log_fit(scan, estimate.pose);
  const double better = settings_.recover.evidence * (there - fit);
  former_->advantage = std::max(0.0, former_->advantage + news * better);
  if (former_->advantage < settings_.regret) return false;
  tracker_ = std::move(former_->tracker);
  former_.reset();
  challenged_ = false;
  lost_for_ = 0.0;
  agreement_.begin_anew();
  agreement_.add(agreement(there), news);
  quality_.begin_anew(std::exp(there));
  result.estimate = estimate;
  result.believes = believes_converged(estimate);
  return true;
}

void Localizer::follow(const PoseEstimate& estimate) {
  tracker_.start(around(filter_.particles(), estimate.pose));
  tracking_ = true;
  challenged_ = false;
  sure_for_ = 0.0;
  lost_for_ = 0.0;
}

SampledScan Localizer::sample(const RecordedScan& scan, std::size_t beams) const {
  return sample_beams(scan, beams, settings_.max_range_m, settings_.height_m);
}

UpdateReport Localizer::update_filter(const RecordedScan& scan, const LookSettings& how) {
  const SampledScan seen = sample(scan, how.beams);
  turned_ = TurnedWeigher(weigher_, seen.heading);
  turned_beams_ = seen.laser.rays;
  ScanLook look{&turned_, seen.laser, settings_.filter.likelihood};
  look.likelihood.sigma_m = how.sigma_m;
  look.temper = std::min(1.0, how.evidence / static_cast<double>(seen.laser.rays));
  look.elsewhere = how.elsewhere;
  look.elsewhere_particles = how.elsewhere_particles;
  look.least_particles = how.least_particles;
  look.nearby_share = settings_.filter.nearby_share;
  filter_.use(look);
  return filter_.update(seen.ranges);
}

double Localizer::agreement(double log_fit) const {
  return agreeing_share(log_fit, settings_.filter.likelihood, settings_.max_range_m);
}

// Mean over the beams. Always by the same σm, so that what the scans fitted then and now can be
// compared.
double Localizer::log_fit(const RecordedScan& scan, const Pose& pose) const {
  const SampledScan seen = sample(scan, settings_.search.beams);
  double log_factor = 0.0;
  TurnedWeigher(weigher_, seen.heading)
      .weigh(seen.ranges, seen.laser, settings_.filter.likelihood, {&pose, 1}, {&log_factor, 1}, 1);
  return log_factor / static_cast<double>(seen.laser.rays);
}

RecordedSettings recorded_settings() {
  RecordedSettings settings;
  FilterSettings& filter = settings.filter;
  filter = robust_settings();
  filter.keep_effective = 0.0;
  filter.first_sweeps = 0;
  filter.place_power = 1.0;
  filter.elsewhere_worth = 1e-3;
  filter.settled_share = 2.0;
  filter.first_particles = 200000;
  filter.particles = 20000;
  filter.likelihood = {LikelihoodKind::kRobust, 1.0, 0.5, 0.5, 0.15};
  filter.shortest_move_m = 0.01;
  filter.longest_move_m = 0.3;
  filter.smallest_turn_deg = 0.1;
  filter.largest_turn_deg = 2.0;
  filter.odometry = {0.1, 0.05, 0.1, 0.05};
  filter.nearby_share = 0.3;
  filter.kld = KldSettings{};
  filter.least_part = 1.0 / 3.0;
  settings.lost_share = 0.6;
  settings.confirmation = 8;
  settings.quality = {0.05, 0.4};
  settings.least_agreement = 0.42;
  settings.search_agreement = 0.47;
  settings.content_agreement = 0.55;
  settings.conviction = 60.0;
  settings.conviction_scans = 5.0;
  settings.regret_scans = 20.0;
  settings.regret = 6.0;
  settings.search = {61, 0.15, 8.0, 8000, 0.01, 6000};
  TrackerSettings& tracker = settings.tracker;
  tracker.stages = {{46, 0.2, 12.0}, {61, 0.1, 20.0}, {91, 0.045, 36.0}, {91, 0.045, 36.0}};
  tracker.kld = {0.1, 2.326, 0.5, 10.0, 100};
  settings.recover = {61, 0.15, 8.0, 3000, 5e-4, 3000};
  return settings;
}

RecordedSettings recorded_report_settings() {
  RecordedSettings settings;
  settings.filter = report_settings();
  const double all = std::numeric_limits<double>::infinity();
  settings.search =
      settings.recover = {131, settings.filter.likelihood.sigma_m, all, settings.filter.particles};
  settings.max_range_m = 15.0;
  return settings;
}

}  // namespace mapwright::navcore
