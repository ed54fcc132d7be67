#include "cli/localize/recorded_answer.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace mapwright::cli {
namespace {

template <class... Values>
std::string printed(const char* format, Values... values) {
  char line[240];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::string iteration_line(const navcore::RecordedIteration& i) {
  const Pose& pose = i.estimate.pose;
  std::string line =
      printed("%6zu %9zu %5zu %9.2f %6.2f %9.3f %9.3f %8.2f", i.scan, i.update.particles, i.beams,
              i.estimate.spread_m, i.estimate.mode_share, pose.x, pose.y, pose.theta.degrees());
  if (i.reference) {
    line += printed(" %8.3f %9.2f", i.position_error_m, i.heading_error.degrees());
  }
  return line + "\n";
}

std::string verdict_line(const navcore::RecordedVerdict& verdict, const navcore::RecordedRun& run) {
  if (!verdict.strict) return "not localized\n";
  return printed("localized from scan %zu on, after %.1f m; error median %.3f m, p95 %.3f m\n",
                 run.iterations[*verdict.right_from].scan, verdict.way_m,
                 verdict.median_error_m.value_or(0.0), verdict.p95_error_m.value_or(0.0));
}

}  // namespace

bool JudgedRun::converged() const {
  return verdict ? verdict->strict : run.iterations.back().believes;
}

RecordedSummary summarize(const std::vector<JudgedRun>& runs) {
  RecordedSummary summary;
  std::vector<double> way_m, errors_m;
  for (const auto& [run, verdict] : runs) {
    ++summary.runs;
    for (const auto& iteration : run.iterations) {
      summary.believed += iteration.believes ? 1 : 0;
      summary.rightly_believed += iteration.believes && iteration.is_right() ? 1 : 0;
    }
    if (!verdict || !verdict->strict) continue;
    ++summary.strict;
    summary.strict_from_start += verdict->strict_from_start ? 1 : 0;
    way_m.push_back(verdict->way_m);
    for (std::size_t i = *verdict->right_from; i < run.iterations.size(); ++i) {
      errors_m.push_back(run.iterations[i].position_error_m);
    }
  }
  summary.way_m = navcore::median_and_p95(way_m);
  summary.position_error_m = navcore::median_and_p95(errors_m);
  return summary;
}

void write_recorded_run_text(std::ostream& out, const JudgedRun& run) {
  const bool compared = run.verdict.has_value();
  out << "  scan particles beams  spread m  share       x m       y m  heading"
      << (compared ? "  error m error deg\n" : "\n");
  for (const auto& iteration : run.run.iterations) out << iteration_line(iteration);
  if (run.verdict) {
    out << verdict_line(*run.verdict, run.run);
  } else {
    out << (run.converged() ? "sure of its place at the end\n" : "not sure of its place\n");
  }
}

void write_recorded_batch_text(std::ostream& out, const std::vector<JudgedRun>& runs) {
  out << " first   last  localized from   way m  median m     p95 m\n";
  for (const auto& [run, verdict] : runs) {
    out << printed("%6zu %6zu", run.first_scan, run.last_scan);
    if (!verdict->strict) {
      out << "               -\n";
      continue;
    }
    out << printed(" %15zu %7.1f %9.3f %9.3f\n", run.iterations[*verdict->right_from].scan,
                   verdict->way_m, verdict->median_error_m.value_or(0.0),
                   verdict->p95_error_m.value_or(0.0));
  }
  const RecordedSummary all = summarize(runs);
  out << printed("localized %zu of %zu, %zu of them from the start", all.strict, all.runs,
                 all.strict_from_start);
  if (all.position_error_m) {
    out << printed("; error median %.3f m, p95 %.3f m; way to it median %.1f m, p95 %.1f m",
                   all.position_error_m->median, all.position_error_m->p95, all.way_m->median,
                   all.way_m->p95);
  }
  if (all.believed > 0) {
    out << printed(
        "\nsure of its place after %zu scans, and right in %.1f %% of them", all.believed,
        100.0 * static_cast<double>(all.rightly_believed) / static_cast<double>(all.believed));
  }
  out << '\n';
}

std::string speed_text(const std::vector<JudgedRun>& runs) {
  std::vector<double> scan_s;
  double processor_s = 0.0, log_s = 0.0, first_s = 0.0;
  for (const auto& [run, verdict] : runs) {
    for (const auto& iteration : run.iterations) processor_s += iteration.processor_s;
    for (std::size_t i = 1; i < run.iterations.size(); ++i) {
      scan_s.push_back(run.iterations[i].processor_s);
    }
    first_s = std::max(first_s, run.iterations.front().processor_s);
    log_s += run.iterations.back().time_s - run.iterations.front().time_s;
  }
  const auto spread = navcore::median_and_p95(scan_s);
  std::string text = printed("first scan %.1f ms of one core", 1e3 * first_s);
  if (spread) {
    text +=
        printed(", others median %.3f ms, p95 %.3f ms", 1e3 * spread->median, 1e3 * spread->p95);
  }
  if (processor_s > 0.0 && log_s > 0.0) {
    text += printed("; all %.0f times faster than the robot drove", log_s / processor_s);
  }
  return text;
}

}  // namespace mapwright::cli
