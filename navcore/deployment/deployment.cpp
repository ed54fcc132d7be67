#include "navcore/deployment/deployment.hpp"

namespace mapwright::navcore {

DeploymentOutcome run_deployment(const Map& map, const DeploymentSettings& settings) {
  const FreeSpace space(map, settings.ramps);
  ReachabilityOptions options;
  options.radius_m = settings.robot_radius_m;
  options.resolution_m = settings.reachability_resolution_m;
  const ReachabilityMap reachability(space, options);
  DeploymentOutcome outcome;
  outcome.reachability = {settings.robot_radius_m, reachability.areas(),
                          reachability.largest_fraction(), reachability.resolution_m()};
  if (reachability.areas().empty()) return outcome;
  if (settings.plans > 0) {
    PlanningTrialsSettings planning;
    planning.trials = settings.plans;
    planning.radius_m = settings.robot_radius_m;
    outcome.planning = run_planning_trials(space, reachability, planning, settings.seed);
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
