#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>

#include "validators/deployment/blame.hpp"
#include "validators/deployment/deployment_gate.hpp"
#include "validators/deployment/localizability_findings.hpp"
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

using navcore::Bottleneck;
using navcore::TravelArea;

std::string way_in(const Map& map, const std::optional<Bottleneck>& gap) {
  if (!gap) return "it is closed all around";
  return "the widest way in is " + gap_text(map, *gap);
}

// Nothing leads to it: what is behind a gap is told by the finding in the gap.
Finding closed_area(const DeploymentOutcome& outcome, const TravelArea& area) {
  return finding_at(FindingCode::N102,
                    robot_text(outcome) + " cannot get from the largest area to the " +
                        rounded(area.area_m2, 1) + " m² around " + place_text(area.at) +
                        ": it is closed all around; open the way in, or close the outline around "
                        "it if it is solid",
                    area.at);
}

// A gap, and the areas that it keeps the robot from, largest first.
struct NarrowPassage {
  Bottleneck gap;
  std::vector<const TravelArea*> areas;
};

std::string behind(const NarrowPassage& passage) {
  const TravelArea& largest = *passage.areas.front();
  if (passage.areas.size() == 1) {
    return "the " + rounded(largest.area_m2, 1) + " m² around " + place_text(largest.at);
  }
  double sum_m2 = 0.0;
  for (const TravelArea* area : passage.areas) sum_m2 += area->area_m2;
  return std::to_string(passage.areas.size()) + " areas of " + rounded(sum_m2, 1) +
         " m² together, the largest around " + place_text(largest.at);
}

Finding narrow_passage(const MapDocument& document, const DeploymentOutcome& outcome,
                       const NarrowPassage& passage) {
  const Bottleneck& gap = passage.gap;
  Finding finding =
      finding_at(FindingCode::N106,
                 "a passage " + gap_text(document.map, gap) + ", is too narrow for " +
                     robot_text(outcome) + ", and no wider way leads to " + behind(passage) +
                     "; widen it by " + metres(2.0 * outcome.reachability.radius_m - gap.width_m) +
                     " m if it is wider in reality",
                 gap.at);
  blame(document, gap, finding);
  for (const TravelArea* area : passage.areas) finding.geometry.points.push_back(area->at);
  return finding;
}

void add_to_passages(const TravelArea& area, std::vector<NarrowPassage>& passages) {
  const auto passage =
      std::find_if(passages.begin(), passages.end(),
                   [&](const NarrowPassage& other) { return other.gap.at == area.gap->at; });
  if (passage == passages.end()) {
    passages.push_back({*area.gap, {&area}});
  } else {
    passage->areas.push_back(&area);
  }
}

// One finding for each cause: a closed area, or a gap with all areas behind it.
void add_areas(const MapDocument& document, const DeploymentOutcome& outcome, double min_area_m2,
               std::vector<Finding>& findings) {
  const auto& areas = outcome.reachability.areas;
  if (areas.empty()) {
    findings.push_back(make_finding(
        FindingCode::N101, "nowhere in the map can " + robot_text(outcome) +
                               " stand; see whether an outline runs the wrong way round the site"));
  }
  std::vector<NarrowPassage> passages;
  for (std::size_t i = 1; i < areas.size(); ++i) {
    if (areas[i].area_m2 < min_area_m2) continue;
    if (areas[i].gap) {
      add_to_passages(areas[i], passages);
    } else {
      findings.push_back(closed_area(outcome, areas[i]));
    }
  }
  for (const auto& passage : passages) {
    findings.push_back(narrow_passage(document, outcome, passage));
  }
}

void add_cut_off_places(const MapDocument& document, const DeploymentOutcome& outcome,
                        std::vector<Finding>& findings) {
  for (const auto& place : outcome.reachability.cut_off_places) {
    const Obstacle& obstacle = document.map.obstacles[place.obstacle];
    std::string message =
        robot_text(outcome) + " cannot get to '" + place.name + "' (" + name_of(obstacle) + "): ";
    message +=
        place.at
            ? "beside it, at " + place_text(*place.at) + ", " + way_in(document.map, place.gap)
            : "there is no room for it within " + metres(tolerance::kBesidePlace_m) + " m of it";
    if (!place.at && place.gap) message += ", and " + way_in(document.map, place.gap);
    Finding finding = make_finding(FindingCode::N105, std::move(message));
    finding.at = place.at;
    finding.obstacle = obstacle.id;
    if (place.gap) show(*place.gap, finding);
    if (!finding.at && !obstacle.segments.empty()) finding.at = obstacle.segments.front().a;
    finding.place = document.index.place(document.text, place.obstacle, ObstacleField::kSemantic);
    findings.push_back(std::move(finding));
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

std::vector<Finding> deployment_findings(const MapDocument& document,
                                         const DeploymentOutcome& outcome,
                                         const GateOptions& options) {
  std::vector<Finding> findings;
  if (!outcome.failure.empty()) return findings;
  add_areas(document, outcome, options.min_unreachable_m2, findings);
  add_cut_off_places(document, outcome, findings);
  if (outcome.planning) add_missed_plans(*outcome.planning, findings);
  if (outcome.localization) add_lost_runs(*outcome.localization, options.min_converged, findings);
  if (outcome.localizability) {
    auto weak =
        localizability_findings(outcome.localizability->field, outcome.localizability->areas);
    std::move(weak.begin(), weak.end(), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace mapwright::validators
