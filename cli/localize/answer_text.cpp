#include <cstdio>
#include <ostream>

#include "cli/localize/answer_writers.hpp"

namespace mapwright::cli {
namespace {

template <class... Values>
void print(std::ostream& out, const char* format, Values... values) {
  char line[160];
  std::snprintf(line, sizeof line, format, values...);
  out << line;
}

const char* verdict(const navcore::ExperimentRun& run) {
  if (run.converged()) return "converged";
  return run.mistaken() ? "mistaken: sure of a wrong place" : "not converged";
}

double percent(std::size_t part, std::size_t whole) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void write_wrong_runs(std::ostream& out, const std::vector<navcore::ExperimentRun>& runs,
                      const navcore::TrialSummary& summary) {
  if (summary.depleted + summary.alike == 0) return;
  print(out, "wrong at the end %zu: the true place lost %zu, places alike %zu\n",
        summary.depleted + summary.alike, summary.depleted, summary.alike);
  out << "  seed  error m  share  share of the truth  evidence for the truth\n";
  for (const auto& run : runs) {
    const auto& last = run.iterations.back();
    if (last.is_right()) continue;
    print(out, "%6llu %8.2f %6.2f %19.1e %23.2f\n", static_cast<unsigned long long>(run.seed),
          last.position_error_m, last.estimate.mode_share, last.truth_share,
          run.truth_evidence.value_or(0.0));
  }
}

void write_reliability(std::ostream& out, const navcore::TrialSummary& summary) {
  out << "share from  iterations  mean share %  right %\n";
  for (const auto& row : summary.reliability) {
    if (row.iterations == 0) continue;
    print(out, "%10.2f %11zu %13.1f %8.1f\n", row.from_share, row.iterations,
          100.0 * row.mean_share, percent(row.right, row.iterations));
  }
  if (summary.sure == 0) return;
  print(out, "took itself for converged in %zu iterations, rightly in %.1f %%\n", summary.sure,
        percent(summary.sure_right, summary.sure));
}

void write_tracking(std::ostream& out, const navcore::BoundSummary& tracking) {
  print(out, "all iterations: position error median %.4f m, p95 %.4f m, rms %.4f m; ",
        tracking.error_m.median, tracking.error_m.p95, tracking.rms_error_m);
  print(out, "sequential Fisher bound rms %.4f m, ratio %.2f\n", tracking.rms_bound_m,
        tracking.rms_error_m / tracking.rms_bound_m);
}

}  // namespace

void write_run_text(std::ostream& out, const navcore::ExperimentRun& run,
                    const std::vector<navcore::AccuracyBound>& bounds) {
  out << "   n  particles  effective  spread m  share  error m  error deg  bound m\n";
  for (const auto& i : run.iterations) {
    print(out, "%4zu %10zu %10.0f %9.2f %6.2f %8.3f %10.2f %8.3f\n", i.n, i.update.particles,
          i.update.effective_particles, i.estimate.spread_m, i.estimate.mode_share,
          i.position_error_m, i.heading_error.degrees(),
          navcore::position_bound_m(bounds[i.n - 1]));
  }
  const Pose& pose = run.iterations.back().estimate.pose;
  print(out, "estimate (%.3f, %.3f) heading %.2f: ", pose.x, pose.y, pose.theta.degrees());
  out << verdict(run) << '\n';
}

void write_trials_text(std::ostream& out, const std::vector<navcore::ExperimentRun>& runs,
                       const TrialsAnswer& answer) {
  const navcore::TrialSummary& summary = answer.summary;
  print(out, "after n iterations: share of %zu runs within %.1f m and %.0f degrees of the truth, ",
        summary.trials, navcore::kRight_m, navcore::kRight_deg);
  print(out, "within %.1f m, position error\n", navcore::kRight_m);
  out << "   n  right %  position %  median m     p95 m\n";
  for (const auto& after : summary.after) {
    print(out, "%4zu %8.1f %11.1f %9.3f %9.3f\n", after.n, percent(after.right, summary.trials),
          percent(after.right_position, summary.trials), after.position_error_m.median,
          after.position_error_m.p95);
  }
  print(out, "converged %zu of %zu, mistaken %zu", summary.converged, summary.trials,
        summary.mistaken);
  if (const auto& n = summary.iterations_to_converge) {
    print(out, "; iterations to converge: median %.1f, p95 %.1f", n->median, n->p95);
  }
  out << '\n';
  write_reliability(out, summary);
  write_wrong_runs(out, runs, summary);
  if (answer.tracking) write_tracking(out, *answer.tracking);
}

}  // namespace mapwright::cli
