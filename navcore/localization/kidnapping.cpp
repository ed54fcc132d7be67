#include "navcore/localization/kidnapping.hpp"

#include <cassert>

namespace mapwright::navcore {
namespace {

// What leads from `from` to `to`, put behind `at`.
Pose carried_on(const Pose& from, const Pose& to, const Pose& at) {
  const Angle turn = at.theta - from.theta;
  const Point ahead = unit_vector(turn), way = to.position() - from.position();
  const Point turned{way.x * ahead.x - way.y * ahead.y, way.x * ahead.y + way.y * ahead.x};
  return {at.x + turned.x, at.y + turned.y, (to.theta + turn).wrapped()};
}

}  // namespace

std::vector<RecordedStep> spliced(std::span<const RecordedStep> first,
                                  std::span<const RecordedStep> second) {
  assert(!first.empty() && !second.empty());
  std::vector<RecordedStep> steps(first.begin(), first.end());
  const Pose odometry = first.back().odometry;
  const double first_s = first.back().scan.time_s - first.front().scan.time_s;
  const double pause_s = first.size() > 1 ? first_s / static_cast<double>(first.size() - 1) : 1.0;
  const double later_s = first.back().scan.time_s + pause_s - second.front().scan.time_s;
  for (const RecordedStep& step : second) {
    steps.push_back(step);
    steps.back().odometry = carried_on(second.front().odometry, step.odometry, odometry);
    steps.back().scan.time_s += later_s;
  }
  return steps;
}

KidnappingVerdict judge_kidnapping(const RecordedRun& run, std::size_t before) {
  assert(before > 0 && before < run.iterations.size());
  const auto elsewhere = run.iterations.begin() + static_cast<std::ptrdiff_t>(before);
  KidnappingVerdict verdict;
  verdict.right_before = run.iterations[before - 1].is_right();
  verdict.carried_m =
      distance(run.iterations[before - 1].reference->position(), elsewhere->reference->position());
  const RecordedVerdict rest =
      judge({before, run.iterations.size() - 1, {elsewhere, run.iterations.end()}});
  verdict.recovered = rest.strict;
  if (!rest.strict) return verdict;
  verdict.scans = *rest.right_from + 1;
  verdict.way_m = rest.way_m;
  return verdict;
}

}  // namespace mapwright::navcore
