#include "navcore/exact/plan_exact.hpp"

#include <cstdio>

namespace mapwright::navcore {
namespace {

std::string metres(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4f m", value);
  return buffer;
}

std::string why_not_standing(const ExactPlanner& planner, const ExactAnswer& answer) {
  const bool is_start = answer.start != PlaceState::kFree;
  const PlaceState state = is_start ? answer.start : answer.goal;
  std::string reason = std::string(is_start ? "start" : "goal") + " is ";
  reason += to_string(state);
  if (state != PlaceState::kBlocked) return reason;
  return reason + " (counted with an error of up to " + metres(planner.offset_error().elsewhere_m) +
         ")";
}

std::string why_undecided(const ExactPlanner& planner, const PlanningResult& result) {
  std::string reason = "whether there is a way lies within the error of the exact planner, " +
                       metres(planner.snapping_error_m() + 1e-9) +
                       " by which walls were moved to its grid";
  if (result.bottleneck_m) {
    reason += ": the widest way is " + metres(*result.bottleneck_m) + " wide where it is narrowest";
  }
  return reason;
}

// Rounding of walls to the grid, if there was any.
std::string caution_of(const ExactPlanner& planner) {
  const auto at = planner.snapped_at();
  if (!at) return {};
  char buffer[160];
  std::snprintf(buffer, sizeof buffer,
                "the exact planner moved walls to its grid of 1 mm, by %.2f mm at most (see (%.3f, "
                "%.3f)); its answer is that of the moved walls",
                1e3 * planner.snapping_error_m(), at->x, at->y);
  return buffer;
}

}  // namespace

PlanningResult plan_exact(const ExactPlanner& planner, const PlanQuery& query) {
  PlanningResult result;
  result.is_shortest = true;
  result.caution = caution_of(planner);
  ExactAnswer answer = planner.plan(query.start, query.goal);
  if (answer.start != PlaceState::kFree || answer.goal != PlaceState::kFree) {
    result.reason = why_not_standing(planner, answer);
    return result;
  }
  result.solved = !answer.path.empty();
  result.path = std::move(answer.path);
  for (const BarrierSide& side : answer.barrier) result.barrier.push_back({side.from, side.to});
  if (const auto narrow = planner.bottleneck(query.start, query.goal)) {
    result.bottleneck_m = narrow->width_m;
    result.bottleneck_at = narrow->at;
  }
  if (answer.verdict == Verdict::kUndecided) {
    result.reason = why_undecided(planner, result);
  } else {
    result.reachable = answer.verdict == Verdict::kReachable;
  }
  return result;
}

}  // namespace mapwright::navcore
