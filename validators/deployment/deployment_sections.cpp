#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "validators/deployment/deployment_gate.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::ordered_json;
using navcore::DeploymentOutcome;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

ReportSection localization_section(const navcore::LocalizationTrials& trials) {
  Json json;
  json["trials"] = trials.trials;
  json["converged"] = trials.converged;
  json["position_error_m"]["median"] = trials.median_error_m;
  json["position_error_m"]["p95"] = trials.p95_error_m;
  return {"localization", json.dump(),
          formatted("localization: %zu of %zu runs converged, position error %.3f m (median), "
                    "%.3f m (95 of 100)",
                    trials.converged, trials.trials, trials.median_error_m, trials.p95_error_m)};
}

ReportSection planning_section(const navcore::PlanningTrials& trials) {
  Json json;
  json["trials"] = trials.trials;
  json["solved"] = trials.solved;
  json["missed"] = Json::array();
  for (const auto& pair : trials.missed) {
    json["missed"].push_back({{"start", {pair.start.x, pair.start.y}},
                              {"goal", {pair.goal.x, pair.goal.y}},
                              {"iterations", pair.iterations}});
  }
  return {"planning", json.dump(),
          formatted("planning: %zu of %zu pairs solved", trials.solved, trials.trials)};
}

Json area_json(const navcore::ReachableArea& area) {
  Json json;
  json["area_m2"] = area.area_m2;
  json["at"] = {area.at.x, area.at.y};
  json["bbox"] = {area.box.min_x, area.box.min_y, area.box.max_x, area.box.max_y};
  return json;
}

ReportSection reachability_section(const navcore::ReachabilityOutcome& outcome,
                                   double min_area_m2) {
  Json json;
  json["radius_m"] = outcome.radius_m;
  json["components"] = outcome.areas.size();
  json["largest_fraction"] = outcome.largest_fraction;
  json["unreachable"] = Json::array();
  for (std::size_t i = 1; i < outcome.areas.size(); ++i) {
    if (outcome.areas[i].area_m2 >= min_area_m2) {
      json["unreachable"].push_back(area_json(outcome.areas[i]));
    }
  }
  json["resolution_m"] = outcome.resolution_m;
  return {
      "reachability", json.dump(),
      formatted("reachability for radius %g m: %s, the largest holds %.1f %% of the free ground",
                outcome.radius_m, counted(outcome.areas.size(), "area").c_str(),
                100.0 * outcome.largest_fraction)};
}

std::string verdict_text(const std::vector<Finding>& findings) {
  const auto count = [&](Severity severity) {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(),
                      [&](const Finding& finding) { return finding.severity == severity; }));
  };
  const bool fail = has_errors(findings);
  return std::string("verdict: ") + (fail ? "fail, " : "pass, ") +
         counted(count(Severity::kError), "error") + ", " +
         counted(count(Severity::kWarning), "warning");
}

ReportSection not_run(const char* key, const char* why) {
  return {key, "null", std::string(key) + ": not run, " + why};
}

}  // namespace

std::vector<ReportSection> deployment_sections(const GateOutcome& outcome,
                                               const GateOptions& options) {
  std::vector<ReportSection> sections;
  const bool in_map = outcome.deployment.has_value();
  const bool stands = in_map && !outcome.deployment->reachability.areas.empty();
  const char* why = !in_map  ? "the border cannot be used"
                    : stands ? "not asked for"
                             : "the robot can stand nowhere";
  const DeploymentOutcome none;
  const DeploymentOutcome& run = in_map ? *outcome.deployment : none;
  sections.push_back(run.localization ? localization_section(*run.localization)
                                      : not_run("localization", why));
  sections.push_back(run.planning ? planning_section(*run.planning) : not_run("planning", why));
  sections.push_back(in_map ? reachability_section(run.reachability, options.min_unreachable_m2)
                            : not_run("reachability", why));
  sections.push_back({"", "", verdict_text(outcome.findings)});
  return sections;
}

}  // namespace mapwright::validators
