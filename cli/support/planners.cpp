#include "cli/support/planners.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "cli/support/error.hpp"
#include "navcore/exact/plan_exact.hpp"
#include "navcore/planning/planner.hpp"

namespace mapwright::cli {
namespace {

using navcore::LegPlanner;
using navcore::PlanQuery;

LegPlanner make_rrt(const PlannerContext& context) {
  return [&space = context.space, options = context.rrt](const PlanQuery& query, Random& random) {
    return navcore::plan_rrt(space, query, options, random);
  };
}

LegPlanner make_balanced_rrt(const PlannerContext& context) {
  return [&space = context.space, options = context.rrt](const PlanQuery& query, Random& random) {
    return navcore::plan_balanced_rrt(space, query, options, random);
  };
}

LegPlanner make_exact(const PlannerContext& context) {
  navcore::ExactOptions options;
  options.radius_m = context.radius_m;
  options.ramps = context.ramps;
  auto planner = std::make_shared<const navcore::ExactPlanner>(
      value_or_throw(navcore::ExactPlanner::build(context.map, options)));
  return
      [planner](const PlanQuery& query, Random&) { return navcore::plan_exact(*planner, query); };
}

}  // namespace

const std::vector<PlannerEntry>& planners() {
  static const std::vector<PlannerEntry> entries{
      {"rrt", "one random tree, from the start (the report's)", &make_rrt},
      {"balanced-rrt", "two random trees in turns, from start and goal", &make_balanced_rrt},
      {"exact", "the shortest path there is, or the proof that there is none", &make_exact},
  };
  return entries;
}

std::string planner_names() {
  std::string names;
  for (const auto& entry : planners()) {
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  return names;
}

const PlannerEntry& find_planner(std::string_view name) {
  const auto& all = planners();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const PlannerEntry& entry) { return entry.name == name; });
  if (found == all.end()) {
    fail_usage("--planner: '" + std::string(name) + "' is none of " + planner_names());
  }
  return *found;
}

}  // namespace mapwright::cli
