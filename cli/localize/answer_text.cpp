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

}  // namespace

void write_run_text(std::ostream& out, const navcore::ExperimentRun& run) {
  out << "   n  particles  effective  spread m  share  error m  error deg\n";
  for (const auto& i : run.iterations) {
    print(out, "%4zu %10zu %10.0f %9.2f %6.2f %8.3f %10.2f\n", i.n, i.update.particles,
          i.update.effective_particles, i.estimate.spread_m, i.estimate.mode_share,
          i.position_error_m, i.heading_error.degrees());
  }
  const Pose& pose = run.iterations.back().estimate.pose;
  print(out, "estimate (%.3f, %.3f) heading %.2f: ", pose.x, pose.y, pose.theta.degrees());
  out << verdict(run) << '\n';
}

void write_trials_text(std::ostream& out, const navcore::TrialSummary& summary) {
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
}

}  // namespace mapwright::cli
