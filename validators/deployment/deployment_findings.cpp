#include <cstdio>
#include <string>

#include "validators/deployment/deployment_gate.hpp"
#include "validators/wording.hpp"

namespace mapwright::validators {
namespace {

using navcore::DeploymentOutcome;

std::string rounded(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

std::string robot_text(const DeploymentOutcome& outcome) {
  return "a robot of radius " + metres(outcome.reachability.radius_m) + " m";
}

Finding finding_at(FindingCode code, std::string message, Point at) {
  Finding finding = make_finding(code, std::move(message));
  finding.at = at;
  return finding;
}

void add_unreachable(const DeploymentOutcome& outcome, double min_area_m2,
                     std::vector<Finding>& findings) {
  const auto& areas = outcome.reachability.areas;
  if (areas.empty()) {
    findings.push_back(make_finding(
        FindingCode::N101, "nowhere in the map can " + robot_text(outcome) +
                               " stand; see whether an outline runs the wrong way round the site"));
    return;
  }
  for (std::size_t i = 1; i < areas.size(); ++i) {
    if (areas[i].area_m2 < min_area_m2) continue;
    findings.push_back(
        finding_at(FindingCode::N102,
                   robot_text(outcome) + " cannot get from the largest area to the " +
                       rounded(areas[i].area_m2, 1) + " m² around " + place_text(areas[i].at) +
                       "; open the way in, or close the outline around it if it is solid",
                   areas[i].at));
  }
}

void add_missed_plans(const navcore::PlanningTrials& planning, std::vector<Finding>& findings) {
  for (const auto& pair : planning.missed) {
    findings.push_back(finding_at(FindingCode::N103,
                                  "there is a way from " + place_text(pair.start) + " to " +
                                      place_text(pair.goal) + ", but the planner found none in " +
                                      std::to_string(pair.iterations) +
                                      " iterations; look for a narrow passage between them",
                                  pair.start));
    findings.back().geometry = {{pair.start, pair.goal}, {{pair.start, pair.goal}}, {}};
  }
}

void add_lost_runs(const navcore::LocalizationTrials& trials, double min_converged,
                   std::vector<Finding>& findings) {
  const double needed = min_converged * static_cast<double>(trials.trials);
  if (trials.lost.empty() || static_cast<double>(trials.converged) >= needed) return;
  const auto& worst = trials.lost.front();
  findings.push_back(finding_at(FindingCode::N104,
                                "the robot found its place in " + std::to_string(trials.converged) +
                                    " of " + std::to_string(trials.trials) +
                                    " runs only; lost for example from " +
                                    place_text(worst.start.position()) + " on, " +
                                    rounded(worst.position_error_m, 2) + " m off at the end",
                                worst.start.position()));
}

}  // namespace

std::vector<Finding> deployment_findings(const DeploymentOutcome& outcome,
                                         const GateOptions& options) {
  std::vector<Finding> findings;
  add_unreachable(outcome, options.min_unreachable_m2, findings);
  if (outcome.planning) add_missed_plans(*outcome.planning, findings);
  if (outcome.localization) add_lost_runs(*outcome.localization, options.min_converged, findings);
  return findings;
}

}  // namespace mapwright::validators
