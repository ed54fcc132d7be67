#include "navcore/localization/recorded_run.hpp"

#include <cassert>
#include <cmath>
#include <ctime>
#include <limits>

#include "navcore/localization/experiment.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::navcore {
namespace {

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The filter, and the beams it looks at.
class Localizer {
 public:
  Localizer(const FreeSpace& space, const ScanWeigher& weigher, const RecordedSettings& settings,
            std::uint64_t seed)
      : space_(space),
        settings_(settings),
        weigher_(weigher),
        turned_(weigher, Angle()),
        filter_(turned_, {}, settings.filter, seed),
        quality_(settings.quality) {}

  bool start() {
    if (!settings_.initial_pose) return filter_.start_anywhere(space_, {});
    filter_.start_at(*settings_.initial_pose, settings_.initial_sigma_m,
                     settings_.initial_sigma_deg, &space_);
    was_sure_ = true;
    return true;
  }

  void drive(const OdometryStep& step) { filter_.move(step); }

  RecordedIteration look(const RecordedScan& scan) {
    RecordedIteration result;
    if (lost_for_ >= settings_.patience) start_over();
    const LookSettings& how = choice();
    result.tracked = &how == &settings_.track;
    SampledScan seen = sample_beams(scan, how.beams, settings_.max_range_m, settings_.height_m);
    aim(seen, how);
    result.update = filter_.update(seen.ranges);
    result.beams = seen.laser.rays;
    result.estimate = filter_.estimate();
    result.believes = believes_converged(result.estimate);
    sure_for_ = result.believes ? sure_for_ + 1 : 0;
    was_sure_ = was_sure_ || sure_for_ >= settings_.confirmation;
    quality_.add(fit(seen, result.estimate.pose));
    lost_for_ = was_sure_ && is_lost() ? lost_for_ + 1 : 0;
    if (settings_.keep_particles) {
      result.seen = std::move(seen);
      result.particles = filter_.particles();
    }
    return result;
  }

 private:
  bool is_lost() const { return quality_.share_lost() >= settings_.lost_share; }

  const LookSettings& choice() const {
    if (!was_sure_) return settings_.search;
    return is_lost() || sure_for_ == 0 ? settings_.recover : settings_.track;
  }

  void start_over() {
    filter_.start_anywhere(space_, {});
    quality_ = ScanQuality(settings_.quality);
    was_sure_ = false;
    sure_for_ = lost_for_ = 0;
  }

  void aim(const SampledScan& seen, const LookSettings& how) {
    turned_ = TurnedWeigher(weigher_, seen.heading);
    ScanLook look{&turned_, seen.laser, settings_.filter.likelihood};
    look.likelihood.sigma_m = how.sigma_m;
    look.temper = std::min(1.0, how.evidence / static_cast<double>(seen.laser.rays));
    look.elsewhere = how.elsewhere;
    look.elsewhere_particles = how.elsewhere_particles;
    look.least_particles = how.least_particles;
    filter_.use(look);
  }

  // Always by the same σm, so that what the scans fitted then and now can be compared.
  double fit(const SampledScan& seen, const Pose& pose) const {
    double log_factor = 0.0;
    turned_.weigh(seen.ranges, seen.laser, settings_.filter.likelihood, {&pose, 1},
                  {&log_factor, 1}, 1);
    return std::exp(log_factor / static_cast<double>(seen.laser.rays));
  }

  const FreeSpace& space_;
  const RecordedSettings& settings_;
  const ScanWeigher& weigher_;
  TurnedWeigher turned_;
  ParticleFilter filter_;
  ScanQuality quality_;
  bool was_sure_ = false;     ///< has been converged for long enough, or told where it is
  std::size_t sure_for_ = 0;  ///< scans in a row that it was converged
  std::size_t lost_for_ = 0;  ///< scans in a row that fitted too badly
};

void compare(RecordedIteration& iteration) {
  if (!iteration.reference) return;
  const Pose& pose = iteration.estimate.pose;
  iteration.position_error_m = distance(pose.position(), iteration.reference->position());
  const Angle turn = (pose.theta - iteration.reference->theta).wrapped();
  iteration.heading_error = Angle::from_radians(std::abs(turn.radians()));
}

// The last scans all right, and as far before them as at most 2 % are wrong.
std::optional<std::size_t> right_from(const RecordedRun& run, std::size_t tail) {
  const auto& iterations = run.iterations;
  std::optional<std::size_t> from;
  std::size_t wrong = 0;
  for (std::size_t seen = 1; seen <= iterations.size(); ++seen) {
    const std::size_t i = iterations.size() - seen;
    const bool right = iterations[i].is_right();
    wrong += right ? 0 : 1;
    if (wrong > 0 && seen <= tail) return std::nullopt;
    if (right && 50 * wrong <= seen) from = i;
  }
  return from;
}

}  // namespace

bool RecordedIteration::is_right() const {
  return position_error_m <= kRight_m && heading_error.degrees() <= kRight_deg;
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
  settings.search = {61, 0.15, 8.0, 8000, 0.01, 6000};
  settings.track = {91, 0.04, 36.0, 120};
  settings.recover = {61, 0.15, 8.0, 3000, 5e-4, 3000};
  return settings;
}

RecordedSettings recorded_report_settings() {
  RecordedSettings settings;
  settings.filter = report_settings();
  const double all = std::numeric_limits<double>::infinity();
  settings.search = settings.track =
      settings.recover = {131, settings.filter.likelihood.sigma_m, all, settings.filter.particles};
  settings.max_range_m = 15.0;
  return settings;
}

Result<RecordedRun> run_recorded(const FreeSpace& space, const ScanWeigher& weigher,
                                 const RecordedSettings& settings,
                                 std::span<const RecordedStep> steps, std::size_t first,
                                 std::size_t last, std::uint64_t seed) {
  assert(first <= last && last < steps.size());
  Localizer localizer(space, weigher, settings, seed);
  if (!localizer.start()) return usage_failure("the map has no free space to search");
  RecordedRun run{first, last, {}};
  for (std::size_t i = first; i <= last; ++i) {
    const double start_s = processor_seconds();
    if (i > first) localizer.drive(step_between(steps[i - 1].odometry, steps[i].odometry));
    RecordedIteration iteration = localizer.look(steps[i].scan);
    iteration.processor_s = processor_seconds() - start_s;
    iteration.scan = i;
    iteration.time_s = steps[i].scan.time_s;
    iteration.reference = steps[i].reference;
    compare(iteration);
    run.iterations.push_back(iteration);
  }
  return run;
}

RecordedVerdict judge(const RecordedRun& run) {
  const std::size_t count = run.iterations.size();
  RecordedVerdict verdict;
  verdict.right_from = right_from(run, (count + 9) / 10);
  verdict.strict = verdict.right_from.has_value();
  if (!verdict.strict) return verdict;
  std::size_t wrong = 0;
  for (const auto& iteration : run.iterations) wrong += iteration.is_right() ? 0 : 1;
  verdict.strict_from_start = 50 * wrong <= count;
  std::vector<double> errors_m;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& iteration = run.iterations[i];
    if (i >= *verdict.right_from) errors_m.push_back(iteration.position_error_m);
    if (i == 0 || i > *verdict.right_from) continue;
    verdict.way_m +=
        distance(iteration.reference->position(), run.iterations[i - 1].reference->position());
  }
  verdict.median_error_m = quantile(errors_m, 0.5);
  verdict.p95_error_m = quantile(errors_m, 0.95);
  return verdict;
}

}  // namespace mapwright::navcore
