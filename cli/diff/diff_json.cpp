#include <nlohmann/json.hpp>
#include <ostream>

#include "cli/diff/diff_answer.hpp"
#include "cli/diff/diff_wording.hpp"
#include "cli/support/pose_json.hpp"

namespace mapwright::cli {
namespace {

using Json = nlohmann::ordered_json;

Json xy(Point p) {
  return {p.x, p.y};
}

Json path_json(const std::vector<Point>& path) {
  Json json = Json::array();
  for (const Point p : path) json.push_back(xy(p));
  return json;
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json map_json(const std::string& path, const Map& map) {
  return {{"path", path}, {"obstacles", map.obstacles.size()}, {"segments", segment_count(map)}};
}

Json border_json(const std::optional<Border>& before, const std::optional<Border>& after) {
  if (!before || !after) return nullptr;
  const auto corners = [](const Border& b) { return Json{b.left, b.top, b.right, b.bottom}; };
  return {{"before", corners(*before)}, {"after", corners(*after)}};
}

Json counts_json(const MapDiffCounts& counts) {
  return {{"added", counts.added},
          {"removed", counts.removed},
          {"moved", counts.moved},
          {"reshaped", counts.reshaped},
          {"reattributed", counts.reattributed},
          {"renumbered", counts.renumbered},
          {"unchanged", counts.unchanged}};
}

Json attribute_json(const AttributeChange& change) {
  return {{"field", change.field},
          {"before", change.before},
          {"after", change.after},
          {"segments", change.segments}};
}

Json change_json(const DiffAnswer& answer, const ObstacleChange& change) {
  const auto id = [](const Map& map, const std::optional<std::size_t>& position) {
    return position ? Json(map.obstacles[*position].id) : Json(nullptr);
  };
  Json json;
  json["changes"] = change_kinds(change);
  json["before"] = id(answer.before, change.before);
  json["after"] = id(answer.after, change.after);
  const auto at = place_of(obstacle_of(answer, change));
  json["at"] = at ? xy(*at) : Json(nullptr);
  if (change.moved) {
    json["moved_m"] = length(change.offset);
    json["offset"] = xy(change.offset);
  }
  if (change.reshaped) {
    json["deviation_m"] = change.deviation_m;
    json["reversed"] = change.reversed;
  }
  if (!change.attributes.empty()) {
    json["attributes"] = Json::array();
    for (const auto& attribute : change.attributes) {
      json["attributes"].push_back(attribute_json(attribute));
    }
  }
  return json;
}

Json scans_json(const navcore::ScansDiff& scans, double tolerance_m) {
  Json json;
  json["tolerance_m"] = tolerance_m;
  json["sampled"] = {{"scans", scans.sampled}, {"changed", scans.sampled_changed}};
  json["around_changes"] = {{"scans", scans.focused}, {"changed", scans.focused_changed}};
  json["changed"] = Json::array();
  for (const auto& scan : scans.changed) {
    json["changed"].push_back({{"pose", pose_json(scan.pose)},
                               {"rays", scan.rays},
                               {"largest_m", scan.largest_m},
                               {"sampled", scan.is_sampled}});
  }
  return json;
}

Json routes_json(const navcore::RoutesDiff& routes) {
  Json json = {{"tried", routes.tried},
               {"longer", routes.longer},
               {"shorter", routes.shorter},
               {"impossible", routes.impossible},
               {"possible", routes.possible}};
  json["changed"] = Json::array();
  for (const auto& route : routes.changed) {
    json["changed"].push_back({{"start", xy(route.start)},
                               {"goal", xy(route.goal)},
                               {"before_m", or_null(route.before_m)},
                               {"after_m", or_null(route.after_m)},
                               {"before", path_json(route.before)},
                               {"after", path_json(route.after)}});
  }
  return json;
}

const char* kind_name(navcore::AreaDifference::Kind kind) {
  switch (kind) {
    case navcore::AreaDifference::Kind::kAppeared:
      return "appeared";
    case navcore::AreaDifference::Kind::kVanished:
      return "vanished";
    case navcore::AreaDifference::Kind::kSplit:
      return "split";
    case navcore::AreaDifference::Kind::kJoined:
      return "joined";
  }
  return "";
}

Json areas_json(const navcore::AreasDiff& areas, double radius_m) {
  Json json;
  json["radius_m"] = radius_m;
  json["components"] = {{"before", areas.components_before}, {"after", areas.components_after}};
  json["free_m2"] = {{"before", areas.free_before_m2}, {"after", areas.free_after_m2}};
  json["changed"] = Json::array();
  for (const auto& area : areas.changed) {
    json["changed"].push_back({{"kind", kind_name(area.kind)},
                               {"area_m2", area.area_m2},
                               {"at", xy(area.at)},
                               {"parts", area.parts}});
  }
  return json;
}

Json navigation_json(const DiffAnswer& answer) {
  if (!answer.navigation) return nullptr;
  return {{"scans", scans_json(answer.navigation->scans, answer.settings.scan_tolerance_m)},
          {"routes", routes_json(answer.navigation->routes)},
          {"reachability", areas_json(answer.navigation->areas, answer.settings.robot_radius_m)}};
}

}  // namespace

void write_diff_json(std::ostream& out, const DiffAnswer& answer) {
  Json json;
  json["schema"] = "mapwright.diff/1";
  json["before"] = map_json(answer.path_before, answer.before);
  json["after"] = map_json(answer.path_after, answer.after);
  json["same"] = answer.same();
  json["border"] = border_json(answer.obstacles.border_before, answer.obstacles.border_after);
  json["counts"] = counts_json(answer.obstacles.counts);
  json["obstacles"] = Json::array();
  for (const auto& change : answer.obstacles.changes) {
    json["obstacles"].push_back(change_json(answer, change));
  }
  json["navigation"] = navigation_json(answer);
  if (!answer.navigation_missing.empty()) json["navigation_missing"] = answer.navigation_missing;
  out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace mapwright::cli
