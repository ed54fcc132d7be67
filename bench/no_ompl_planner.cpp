#include "bench/ompl_planner.hpp"

namespace mapwright::bench {

bool has_ompl() {
  return false;
}

navcore::PlanningResult plan_with_ompl_exactly(const navcore::FreeSpace&, const navcore::PlanQuery&,
                                               Random&) {
  return {};
}

navcore::PlanningResult plan_with_ompl_in_steps(const navcore::FreeSpace&,
                                                const navcore::PlanQuery&, Random&) {
  return {};
}

}  // namespace mapwright::bench
