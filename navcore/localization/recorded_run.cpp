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
    RecordedIteration iteration;
    static_cast<LocalizerLook&>(iteration) = localizer.look(steps[i].scan);
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
