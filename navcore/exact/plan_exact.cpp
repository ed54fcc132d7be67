#include "navcore/exact/plan_exact.hpp"

namespace mapwright::navcore {

PlanningResult plan_exact(const ExactPlanner& planner, const PlanQuery& query) {
  PlanningResult result;
  result.is_shortest = true;
  ExactAnswer answer = planner.plan(query.start, query.goal);
  if (answer.start != PlaceState::kFree || answer.goal != PlaceState::kFree) return result;
  if (answer.verdict != Verdict::kUndecided) {
    result.reachable = answer.verdict == Verdict::kReachable;
  }
  result.solved = !answer.path.empty();
  result.path = std::move(answer.path);
  for (const BarrierSide& side : answer.barrier) result.barrier.push_back({side.from, side.to});
  if (const auto narrow = planner.bottleneck(query.start, query.goal)) {
    result.bottleneck_m = narrow->width_m;
    result.bottleneck_at = narrow->at;
  }
  return result;
}

}  // namespace mapwright::navcore
