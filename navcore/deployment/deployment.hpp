// Sends a simulated robot across a map before a real one goes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/deployment/cut_off_places.hpp"
#include "navcore/deployment/localization_trials.hpp"
#include "navcore/deployment/planning_trials.hpp"
#include "navcore/exact/travel_areas.hpp"
#include "navcore/localizability/localizability.hpp"

namespace mapwright::navcore {

struct DeploymentSettings {
  double robot_radius_m = 0.3;
  RampPolicy ramps = RampPolicy::kFree;
  std::size_t plans = 20;                 ///< 0: no planning trials
  std::size_t localization_trials = 10;   ///< 0: none
  ExperimentSettings localization;        ///< its robot radius is the one above
  std::size_t localizability_places = 0;  ///< looked at, about: spread over the border; 0: none
  WeaknessLimits weakness;                ///< of their areas; those of a few cells are passed over
  std::uint64_t seed = 1;
  unsigned threads = 1;  ///< 0: one a core. The outcome does not depend on it
};

struct ReachabilityOutcome {
  double radius_m = 0.0;
  std::vector<TravelArea> areas;  ///< largest first
  double largest_fraction = 0.0;
  double snapping_m = 0.0;  ///< how far walls were moved to the exact planner's grid
  std::optional<Point> snapped_at;
  double resolution_m = 0.0;  ///< what the areas may lack along walls (ExactPlanner::offset_error)
  std::vector<CutOffPlace> cut_off_places;  ///< in the order of the map
  std::size_t places = 0;                   ///< named places of the map, all of them
};

/// How well the robot can know its place, on a grid as coarse as was asked for.
struct LocalizabilityOutcome {
  LocalizabilityField field;
  std::vector<WeakArea> areas;
  LocalizabilitySummary summary;
};

/// What came of it. What was not run is absent.
struct DeploymentOutcome {
  std::string failure;  ///< why nothing could be run (ExactPlanner::build); empty where it could
  ReachabilityOutcome reachability;
  std::optional<PlanningTrials> planning;
  std::optional<LocalizationTrials> localization;
  std::optional<LocalizabilityOutcome> localizability;
};

/// The areas the robot can travel and the named places it cannot get to, planning between random
/// places of the largest area, global localization from random places, and what a scan can tell
/// all over the map. Nothing is planned or localized where the robot can stand nowhere. Requires
/// robot_radius_m ≥ 0.
DeploymentOutcome run_deployment(const Map& map, const DeploymentSettings& settings);

}  // namespace mapwright::navcore
