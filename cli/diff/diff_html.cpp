#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <unordered_map>

#include "cli/diff/diff_answer.hpp"
#include "cli/diff/diff_wording.hpp"
#include "validators/report/html/page.hpp"
#include "validators/report/html/scene.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;
using validators::SceneFacts;
using validators::SceneWriter;

// Later ones are drawn over earlier ones.
enum Layer : std::size_t {
  kUnchanged,
  kRemoved,
  kOldPlace,
  kNewPlace,
  kAttributes,
  kAdded,
  kMoves,
  kOldRoutes,
  kNewRoutes,
  kScans
};

std::vector<validators::SceneLayer> layers() {
  return {{"unchanged", "same"},
          {"removed", "removed"},
          {"moved or reshaped: before", "before"},
          {"moved or reshaped: after", "after"},
          {"other attributes", "changed"},
          {"added", "added"},
          {"moves", "after"},
          {"route before", "before"},
          {"route after", "after"},
          {"scan differs", "scan"}};
}

std::vector<validators::PageLevel> levels() {
  return {{"added", "kind-added-line"},      {"removed", "kind-removed-line"},
          {"reshaped", "kind-after-line"},   {"moved", "kind-after-line"},
          {"changed", "kind-changed-line"},  {"border", "kind-before-line"},
          {"area", "kind-unreachable-line"}, {"route", "kind-before-line"},
          {"scan", "kind-scan-line"}};
}

Layer layer_of(const ObstacleChange& change) {
  if (change.added()) return kAdded;
  if (change.moved || change.reshaped) return kNewPlace;
  return change.attributes.empty() ? kUnchanged : kAttributes;
}

SceneFacts facts_of(const ObstacleChange& change, const DiffAnswer& answer) {
  SceneFacts facts;
  if (change.renumbered) {
    facts.emplace_back("was number", std::to_string(answer.before.obstacles[*change.before].id));
  }
  for (const auto& attribute : change.attributes) {
    facts.emplace_back(attribute.field, attribute.before + " -> " + attribute.after);
  }
  return facts;
}

/// The scene of both maps, and which of its obstacles each change is about.
struct DiffScene {
  SceneWriter writer;
  std::unordered_map<std::size_t, std::size_t> obstacle_of_change;
};

void add_unchanged(const DiffAnswer& answer, SceneWriter& writer) {
  std::set<std::size_t> changed;
  for (const auto& change : answer.obstacles.changes) {
    if (change.after) changed.insert(*change.after);
  }
  for (std::size_t i = 0; i < answer.after.obstacles.size(); ++i) {
    if (changed.count(i) == 0) writer.obstacle(answer.after.obstacles[i], kUnchanged);
  }
}

void add_change(const DiffAnswer& answer, std::size_t number, DiffScene& scene) {
  const auto& change = answer.obstacles.changes[number];
  const bool elsewhere = change.before && change.after && (change.moved || change.reshaped);
  std::size_t shown = 0;
  if (change.before && (change.removed() || elsewhere)) {
    const Layer layer = change.removed() ? kRemoved : kOldPlace;
    shown = scene.writer.obstacle(answer.before.obstacles[*change.before], layer);
  }
  if (change.after) {
    shown = scene.writer.obstacle(answer.after.obstacles[*change.after], layer_of(change),
                                  facts_of(change, answer));
  }
  scene.obstacle_of_change.emplace(number, shown);
  if (!change.moved) return;
  const auto to = place_of(answer.after.obstacles[*change.after]);
  if (to) scene.writer.line(kMoves, std::vector<Point>{*to - change.offset, *to}, true);
}

void add_navigation(const navcore::NavigationDiff& navigation, SceneWriter& writer) {
  for (const auto& route : navigation.routes.changed) {
    if (!route.before.empty()) writer.line(kOldRoutes, route.before, true);
    if (!route.after.empty()) writer.line(kNewRoutes, route.after, true);
  }
  for (const auto& scan : navigation.scans.changed) writer.dot(kScans, scan.pose.position());
}

DiffScene scene_of(const DiffAnswer& answer) {
  DiffScene scene{SceneWriter(answer.after.border, layers()), {}};
  add_unchanged(answer, scene.writer);
  for (std::size_t i = 0; i < answer.obstacles.changes.size(); ++i) add_change(answer, i, scene);
  if (answer.navigation) add_navigation(*answer.navigation, scene.writer);
  return scene;
}

// A row of the page's table, in the manner of a finding.
Json row_json(const DiffAnswer& answer, const DiffScene& scene, const DiffLine& line) {
  Json row;
  row["code"] = line.kind;
  row["severity"] = line.kind;
  row["message"] = line.text;
  row["line"] = nullptr;
  row["column"] = nullptr;
  row["x"] = line.at ? Json(line.at->x) : Json(nullptr);
  row["y"] = line.at ? Json(line.at->y) : Json(nullptr);
  row["obstacle"] = nullptr;
  row["segment"] = nullptr;
  if (line.change) {
    row["obstacle"] = obstacle_of(answer, answer.obstacles.changes[*line.change]).id;
    row["scene_obstacle"] = scene.obstacle_of_change.at(*line.change);
  }
  return row;
}

std::string found_json(const DiffAnswer& answer, const DiffScene& scene) {
  Json json;
  json["path"] = answer.path_before + " → " + answer.path_after;
  json["verdict"] = answer.same() ? "same" : "different";
  json["sections"] = Json::array();
  const auto say = [&](const std::string& line) {
    if (!line.empty()) json["sections"].push_back({{"line", line}});
  };
  say(summary_line(answer));
  say(renumbered_line(answer));
  if (!answer.navigation_missing.empty())
    say("navigation: not compared, " + answer.navigation_missing);
  json["findings"] = Json::array();
  for (const auto& line : diff_lines(answer)) {
    json["findings"].push_back(row_json(answer, scene, line));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void write_diff_html(std::ostream& out, const DiffAnswer& answer) {
  validators::ViewerPage page(out);
  const DiffScene scene = scene_of(answer);
  page.map(found_json(answer, scene), scene.writer.json());
  validators::PageWords words;
  words.title = "mapwright diff";
  words.summary = answer.same() ? "nothing differs" : summary_line(answer);
  words.levels = levels();
  words.columns = {"severity", "obstacle", "message"};
  page.finish(words);
}

}  // namespace mapwright::cli
