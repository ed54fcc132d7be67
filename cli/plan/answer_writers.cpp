#include "cli/plan/answer_writers.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(Point p) {
  return Json::array({p.x, p.y});
}

Json path_json(const std::vector<Point>& path) {
  Json array = Json::array();
  for (const Point p : path) array.push_back(point_json(p));
  return array;
}

Json edges_json(const std::vector<navcore::TreeEdge>& tree) {
  Json array = Json::array();
  for (const auto& edge : tree) {
    array.push_back(Json::array({edge.from.x, edge.from.y, edge.to.x, edge.to.y}));
  }
  return array;
}

template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

void add_proofs(const navcore::PlanningResult& result, Json& json) {
  // Always there, so that a script need not ask first: null is what no planner found out.
  json["reachable"] = optional_json(result.reachable);
  json["bottleneck_m"] = optional_json(result.bottleneck_m);
  json["bottleneck_at"] = result.bottleneck_at ? point_json(*result.bottleneck_at) : Json(nullptr);
  if (!result.barrier.empty()) json["barrier"] = edges_json(result.barrier);
}

// The point stands under `key`, as for places without a name.
void add_place(const Place& place, const char* key, Json& json) {
  json[key] = place.at ? point_json(*place.at) : Json(nullptr);
  if (!place.name.empty()) json[std::string(key) + "_name"] = place.name;
}

Json answer_json(const PlanAnswer& answer, bool with_tree) {
  const auto& total = answer.route.total;
  Json json;
  add_place(answer.query.start, "start", json);
  add_place(answer.query.goal, "goal", json);
  json["solved"] = total.solved;
  json["path"] = path_json(total.path);
  json["length_m"] = total.solved ? Json(answer.length_m) : Json(nullptr);
  json["min_clearance_m"] = optional_json(answer.min_clearance_m);
  json["iterations"] = total.iterations;
  add_proofs(total, json);
  if (!total.solved) json["reason"] = answer.reason;
  if (!total.caution.empty()) json["caution"] = total.caution;
  if (with_tree) {
    json["raw_path"] = path_json(answer.route.raw_path);
    json["tree"] = edges_json(total.tree);
  }
  return json;
}

std::string metres_text(double metres) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f", metres);
  return buffer;
}

void write_answer_text(std::ostream& out, const PlanAnswer& answer) {
  const auto& total = answer.route.total;
  out << place_text(answer.query.start) << " to " << place_text(answer.query.goal) << ": ";
  if (!total.solved) {
    out << "no path: " << answer.reason << '\n';
    return;
  }
  out << "path of " << metres_text(answer.length_m) << " m";
  if (answer.min_clearance_m) {
    out << ", least clearance " << metres_text(*answer.min_clearance_m) << " m";
  }
  out << ", " << total.iterations << " iterations\n";
  if (total.bottleneck_m) out << "  bottleneck " << metres_text(*total.bottleneck_m) << " m\n";
  for (const Point p : total.path) {
    out << "  " << metres_text(p.x) << ' ' << metres_text(p.y) << '\n';
  }
}

}  // namespace

void write_plan_json(std::ostream& out, const PlanSettings& settings,
                     const std::vector<PlanAnswer>& answers, bool with_tree) {
  Json json;
  json["schema"] = "mapwright.plan/1";
  json["planner"] = settings.planner;
  json["radius_m"] = settings.radius_m;
  json["seed"] = settings.seed;
  json["queries"] = Json::array();
  for (const auto& answer : answers) json["queries"].push_back(answer_json(answer, with_tree));
  out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

void write_plan_text(std::ostream& out, const std::vector<PlanAnswer>& answers) {
  for (const auto& answer : answers) write_answer_text(out, answer);
}

}  // namespace mapwright::cli
