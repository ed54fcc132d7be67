#include <algorithm>
#include <cmath>
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

Json known(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

ReportSection localizability_section(const navcore::LocalizabilityOutcome& outcome) {
  const auto& accuracy = outcome.summary.edges_median_m;
  Json json;
  json["places"] = outcome.summary.places;
  json["cell_m"] = outcome.field.grid.cell_m;
  json["position_sd_m"]["median"] = known(accuracy.median);
  json["position_sd_m"]["p95"] = known(accuracy.p95);
  json["inaccurate_share"] = accuracy.share_above;
  json["confusable_share"] = outcome.summary.risk_median.share_above;
  return {"localizability", json.dump(),
          formatted("localizability: a scan tells the position to %.3f m (median of %zu places); "
                    "not well enough on %.1f %%, mistakable on %.1f %%",
                    accuracy.median, outcome.summary.places, 100.0 * accuracy.share_above,
                    100.0 * outcome.summary.risk_median.share_above)};
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

// One of the two sides of a gap; both null for the border.
Json side_json(std::optional<std::uint32_t> obstacle, std::optional<std::uint32_t> segment,
               const std::vector<std::int64_t>& ids) {
  Json json;
  json["obstacle"] = obstacle ? Json(ids[*obstacle]) : Json(nullptr);
  json["segment"] = segment ? Json(*segment + 1) : Json(nullptr);
  return json;
}

Json gap_json(const std::optional<navcore::Bottleneck>& gap, const std::vector<std::int64_t>& ids) {
  if (!gap) return nullptr;
  Json json;
  json["width_m"] = gap->width_m;
  json["at"] = {gap->at.x, gap->at.y};
  json["between"] = {side_json(gap->obstacle_from, gap->segment_from, ids),
                     side_json(gap->obstacle_to, gap->segment_to, ids)};
  return json;
}

Json area_json(const navcore::TravelArea& area, const std::vector<std::int64_t>& ids) {
  Json json;
  json["area_m2"] = area.area_m2;
  json["at"] = {area.at.x, area.at.y};
  json["bbox"] = {area.box.min_x, area.box.min_y, area.box.max_x, area.box.max_y};
  json["gap"] = gap_json(area.gap, ids);
  return json;
}

Json place_json(const navcore::CutOffPlace& place, const std::vector<std::int64_t>& ids) {
  Json json;
  json["name"] = place.name;
  json["obstacle"] = ids[place.obstacle];
  json["at"] = place.at ? Json({place.at->x, place.at->y}) : Json(nullptr);
  json["gap"] = gap_json(place.gap, ids);
  return json;
}

std::string reachability_text(const navcore::ReachabilityOutcome& outcome) {
  std::string text =
      formatted("reachability for radius %g m: %s, the largest holds %.1f %% of the free ground",
                outcome.radius_m, counted(outcome.areas.size(), "area").c_str(),
                100.0 * outcome.largest_fraction);
  if (outcome.snapped_at) {
    text += formatted(", walls moved by %.2f mm at most (see (%.3f, %.3f))",
                      1e3 * outcome.snapping_m, outcome.snapped_at->x, outcome.snapped_at->y);
  }
  if (outcome.places == 0) return text;
  return text + formatted("; %zu of %s can be reached",
                          outcome.places - outcome.cut_off_places.size(),
                          counted(outcome.places, "named place").c_str());
}

ReportSection reachability_section(const navcore::ReachabilityOutcome& outcome, double min_area_m2,
                                   const std::vector<std::int64_t>& ids) {
  Json json;
  json["radius_m"] = outcome.radius_m;
  json["components"] = outcome.areas.size();
  json["largest_fraction"] = outcome.largest_fraction;
  json["unreachable"] = Json::array();
  for (std::size_t i = 1; i < outcome.areas.size(); ++i) {
    if (outcome.areas[i].area_m2 >= min_area_m2) {
      json["unreachable"].push_back(area_json(outcome.areas[i], ids));
    }
  }
  json["resolution_m"] = outcome.resolution_m;
  json["walls_moved_m"] = outcome.snapping_m;
  json["walls_moved_at"] =
      outcome.snapped_at ? Json({outcome.snapped_at->x, outcome.snapped_at->y}) : Json(nullptr);
  json["places"] = outcome.places;
  json["places_cut_off"] = Json::array();
  for (const auto& place : outcome.cut_off_places) {
    json["places_cut_off"].push_back(place_json(place, ids));
  }
  return {"reachability", json.dump(-1, ' ', false, Json::error_handler_t::replace),
          reachability_text(outcome)};
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

ReportSection not_run(const char* key, const std::string& why) {
  return {key, "null", std::string(key) + ": not run, " + why};
}

std::string why_not_run(const GateOutcome& outcome) {
  if (!outcome.deployment) return "the border cannot be used";
  if (!outcome.deployment->failure.empty()) return outcome.deployment->failure;
  if (outcome.deployment->reachability.areas.empty()) return "the robot can stand nowhere";
  return "not asked for";
}

}  // namespace

std::vector<ReportSection> deployment_sections(const GateOutcome& outcome,
                                               const GateOptions& options) {
  std::vector<ReportSection> sections;
  const bool has_run = outcome.deployment && outcome.deployment->failure.empty();
  const std::string why = why_not_run(outcome);
  const DeploymentOutcome none;
  const DeploymentOutcome& run = has_run ? *outcome.deployment : none;
  sections.push_back(run.localization ? localization_section(*run.localization)
                                      : not_run("localization", why));
  if (run.localizability) sections.push_back(localizability_section(*run.localizability));
  sections.push_back(run.planning ? planning_section(*run.planning) : not_run("planning", why));
  sections.push_back(has_run ? reachability_section(run.reachability, options.min_unreachable_m2,
                                                    outcome.obstacle_ids)
                             : not_run("reachability", why));
  sections.push_back({"", "", verdict_text(outcome.findings)});
  return sections;
}

}  // namespace mapwright::validators
