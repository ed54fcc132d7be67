// OMPL's RRTConnect on our maps, as a peer to measure against. Without OMPL, `has_ompl` is false.
#pragma once

#include "navcore/planning/planner.hpp"

namespace mapwright::bench {

bool has_ompl();

/// With our exact test of states and motions; gives up after 10 s. `iterations` stays 0.
navcore::PlanningResult plan_with_ompl_exactly(const navcore::FreeSpace& space,
                                               const navcore::PlanQuery& query, Random& random);

/// With our exact test of states, but motions tested at states 0.1 m apart, as is usual with OMPL.
navcore::PlanningResult plan_with_ompl_in_steps(const navcore::FreeSpace& space,
                                                const navcore::PlanQuery& query, Random& random);

}  // namespace mapwright::bench
