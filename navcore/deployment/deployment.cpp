#include "navcore/deployment/deployment.hpp"

namespace mapwright::navcore {
namespace {

ReachabilityOutcome reachability_of(const TravelAreas& areas, const PlaceFinder& finder,
                                    double radius_m) {
  return {radius_m,
          areas.areas(),
          areas.largest_fraction(),
          areas.planner().snapping_error_m(),
          areas.planner().snapped_at(),
          areas.planner().offset_error().elsewhere_m,
          cut_off_places(finder, areas, radius_m),
          finder.places().size()};
}

}  // namespace

DeploymentOutcome run_deployment(const Map& map, const DeploymentSettings& settings) {
  DeploymentOutcome outcome;
  outcome.reachability.radius_m = settings.robot_radius_m;
  const auto areas = TravelAreas::build(map, settings.robot_radius_m, settings.ramps);
  if (!areas) {
    outcome.failure = areas.error().message;
    return outcome;
  }
  const FreeSpace space(map, settings.ramps);
  outcome.reachability = reachability_of(*areas, PlaceFinder(map, space), settings.robot_radius_m);
  if (areas->areas().empty()) return outcome;
  if (settings.plans > 0) {
    PlanningTrialsSettings planning;
    planning.trials = settings.plans;
    planning.radius_m = settings.robot_radius_m;
    outcome.planning = run_planning_trials(space, *areas, planning, settings.seed);
  }
  if (settings.localization_trials > 0) {
    ExperimentSettings localization = settings.localization;
    localization.robot_radius_m = settings.robot_radius_m;
    outcome.localization = run_localization_trials(
        map, space, localization, settings.localization_trials, settings.seed, settings.threads);
  }
  return outcome;
}

}  // namespace mapwright::navcore
