// The planners the program knows.
#pragma once

#include <string_view>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"
#include "navcore/planning/route.hpp"

namespace mapwright::cli {

/// What a planner is made for. Map and free space outlive the planner.
struct PlannerContext {
  const Map& map;
  const navcore::FreeSpace& space;  ///< of the map, ramps free or avoided
  navcore::RampPolicy ramps = navcore::RampPolicy::kFree;
  double radius_m = 0.0;  ///< of the robot, the same for all queries
  navcore::RrtOptions rrt;
};

/// A planner: `--planner name`. What `make` returns may be called from many threads.
struct PlannerEntry {
  std::string_view name;
  std::string_view summary;
  navcore::LegPlanner (*make)(const PlannerContext& context);
};

/// All planners, in the order help shows them.
const std::vector<PlannerEntry>& planners();

/// "rrt, balanced-rrt …".
std::string planner_names();

/// Throws Error (kUsage) for a name that is not among them.
const PlannerEntry& find_planner(std::string_view name);

}  // namespace mapwright::cli
