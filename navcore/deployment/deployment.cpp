#include "navcore/deployment/deployment.hpp"

#include <algorithm>
#include <cmath>

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

// What a few cells say by chance is no finding.
constexpr double kLeastCells = 4.0;
constexpr double kLeastCell_m = 1.0;

LocalizabilityOutcome localizability_of(const Map& map, const FreeSpace& space,
                                        const DeploymentSettings& settings) {
  LocalizabilitySettings asked;
  asked.laser = settings.localization.laser;
  asked.cell_m = std::max(
      kLeastCell_m,
      std::sqrt(map.border.area_m2() / static_cast<double>(settings.localizability_places)));
  asked.twin_spacing_m = std::max(2.0, asked.cell_m);
  asked.twin_index_poses = 20 * settings.localizability_places;
  asked.robot_radius_m = settings.robot_radius_m;
  asked.threads = settings.threads;
  WeaknessLimits limits = settings.weakness;
  limits.min_area_m2 = std::max(limits.min_area_m2, kLeastCells * asked.cell_m * asked.cell_m);
  LocalizabilityOutcome outcome{localizability_field(map, space, asked), {}, {}};
  outcome.areas = weak_areas(outcome.field, limits);
  outcome.summary = summary_of(outcome.field, limits);
  return outcome;
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
  if (settings.localizability_places > 0) {
    outcome.localizability = localizability_of(map, space, settings);
  }
  return outcome;
}

}  // namespace mapwright::navcore
