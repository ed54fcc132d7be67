// The exact planner in the shape that the other planners have.
#pragma once

#include "navcore/exact/exact_planner.hpp"
#include "navcore/planning/planner.hpp"

namespace mapwright::navcore {

/// Shortest path, whether there is one at all, and the bottleneck on the way, as a PlanningResult.
/// Where there is no way, the barrier. Requires query.radius_m to be the radius of the planner.
/// `reachable` stays empty, and `reason` says why, where the answer depends on the offset's error
/// bound, or a place is not free for the planner.
PlanningResult plan_exact(const ExactPlanner& planner, const PlanQuery& query);

}  // namespace mapwright::navcore
