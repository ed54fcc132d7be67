#include "cli/diff/diff_wording.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mapwright::cli {
namespace {

using navcore::AreaDifference;
using navcore::RouteDifference;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char buffer[240];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

// Whole millimetres, without needless zeros.
std::string metres(double value) {
  const double rounded = std::round(value * 1000.0) / 1000.0;
  return formatted("%g", rounded == 0.0 ? 0.0 : rounded);
}

std::string place(Point p) {
  return "(" + formatted("%.3f", p.x) + ", " + formatted("%.3f", p.y) + ")";
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string name_of(const Obstacle& obstacle) {
  const auto labels = obstacle.semantic.labels();
  std::string name = "obstacle " + std::to_string(obstacle.id);
  if (!labels.empty() && !labels.front().empty()) name += " (" + std::string(labels.front()) + ")";
  return name;
}

std::string shown(const std::string& value) {
  return value.empty() ? "none" : value;
}

// "height_m 3 -> 4 of segments 2, 4".
std::string attribute_text(const AttributeChange& change, std::size_t segments) {
  std::string text = change.field + " " + shown(change.before) + " -> " + shown(change.after);
  if (change.segments.empty()) return text;
  if (change.segments.size() == segments) return text + " of all segments";
  constexpr std::size_t kMostNamed = 8;
  text += change.segments.size() == 1 ? " of segment " : " of segments ";
  for (std::size_t i = 0; i < change.segments.size() && i < kMostNamed; ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(change.segments[i]);
  }
  return change.segments.size() > kMostNamed
             ? text + " … (" + std::to_string(change.segments.size()) + ")"
             : text;
}

std::string shape_text(const DiffAnswer& answer, const ObstacleChange& change) {
  if (change.reversed) return "runs the other way round";
  const auto before = answer.before.obstacles[*change.before].segments.size();
  const auto after = answer.after.obstacles[*change.after].segments.size();
  std::string text = "has another shape, up to " + metres(change.deviation_m) + " m off";
  if (before != after) {
    text += ", " + std::to_string(before) + " -> " + std::to_string(after) + " segments";
  }
  return text;
}

std::string change_text(const DiffAnswer& answer, const ObstacleChange& change) {
  const Obstacle& obstacle = obstacle_of(answer, change);
  const std::string name = name_of(obstacle);
  if (change.added() || change.removed()) {
    std::string text = name + " with " + counted(obstacle.segments.size(), "segment");
    const auto at = place_of(obstacle);
    return at ? text + " at " + place(*at) : text;
  }
  std::vector<std::string> parts;
  if (change.reshaped) parts.push_back(shape_text(answer, change));
  if (change.moved) {
    parts.push_back("moved " + metres(length(change.offset)) + " m by " + place(change.offset));
  }
  for (const auto& attribute : change.attributes) {
    parts.push_back(attribute_text(attribute, obstacle.segments.size()));
  }
  if (change.renumbered) {
    parts.push_back("was number " + std::to_string(answer.before.obstacles[*change.before].id));
  }
  std::string text = name + ": ";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : "; ") + parts[i];
  return text;
}

std::string border_text(const Border& border) {
  return "(" + metres(border.left) + ", " + metres(border.top) + ") (" + metres(border.right) +
         ", " + metres(border.bottom) + ")";
}

std::string area_text(const AreaDifference& area) {
  const std::string size = formatted("%.1f m² around ", area.area_m2) + place(area.at);
  switch (area.kind) {
    case AreaDifference::Kind::kAppeared:
      return size + " where the robot could not stand before";
    case AreaDifference::Kind::kVanished:
      return size + " where the robot cannot stand any more";
    case AreaDifference::Kind::kSplit:
      return size + " are cut into " + counted(area.parts, "part");
    case AreaDifference::Kind::kJoined:
      return size + " join what were " + counted(area.parts, "part");
  }
  return size;
}

std::string route_text(const RouteDifference& route) {
  const std::string ends = "from " + place(route.start) + " to " + place(route.goal) + ": ";
  if (!route.after_m) return ends + formatted("%.2f m before, impossible now", *route.before_m);
  if (!route.before_m) return ends + formatted("impossible before, %.2f m now", *route.after_m);
  return ends + formatted("%.2f m -> %.2f m", *route.before_m, *route.after_m);
}

std::string scans_text(const navcore::ScansDiff& scans, const navcore::ScanDifference& worst) {
  std::string text = std::to_string(scans.sampled_changed) + " of " +
                     counted(scans.sampled, "random scan") + " differ";
  if (scans.focused > 0) {
    text += ", and " + std::to_string(scans.focused_changed) + " of " +
            std::to_string(scans.focused) + " around what changed";
  }
  return text +
         formatted("; most of all, by %.2f m in %zu of the rays, from ", worst.largest_m, worst.rays) +
         place(worst.pose.position());
}

void add_navigation(const navcore::NavigationDiff& navigation, std::vector<DiffLine>& lines) {
  for (const auto& area : navigation.areas.changed) {
    lines.push_back({"area", area_text(area), area.at, {}});
  }
  for (const auto& route : navigation.routes.changed) {
    lines.push_back({"route", route_text(route), route.start, {}});
  }
  const auto& scans = navigation.scans;
  if (scans.changed.empty()) return;
  const auto worst =
      std::max_element(scans.changed.begin(), scans.changed.end(),
                       [](const auto& p, const auto& q) { return p.largest_m < q.largest_m; });
  lines.push_back({"scan", scans_text(scans, *worst), worst->pose.position(), {}});
}

}  // namespace

std::vector<std::string_view> change_kinds(const ObstacleChange& change) {
  std::vector<std::string_view> kinds;
  if (change.added()) kinds.push_back("added");
  if (change.removed()) kinds.push_back("removed");
  if (change.reshaped) kinds.push_back("reshaped");
  if (change.moved) kinds.push_back("moved");
  if (!change.attributes.empty()) kinds.push_back("changed");
  if (change.renumbered) kinds.push_back("renumbered");
  return kinds;
}

const Obstacle& obstacle_of(const DiffAnswer& answer, const ObstacleChange& change) {
  return change.after ? answer.after.obstacles[*change.after]
                      : answer.before.obstacles[*change.before];
}

std::optional<Point> place_of(const Obstacle& obstacle) {
  const Box box = extent(obstacle);
  if (box.is_empty()) return std::nullopt;
  return Point{(box.min_x + box.max_x) / 2.0, (box.min_y + box.max_y) / 2.0};
}

std::vector<DiffLine> diff_lines(const DiffAnswer& answer) {
  std::vector<DiffLine> lines;
  const auto& diff = answer.obstacles;
  if (diff.border_before) {
    lines.push_back({"border",
                     border_text(*diff.border_before) + " -> " + border_text(*diff.border_after),
                     {},
                     {}});
  }
  for (std::size_t i = 0; i < diff.changes.size(); ++i) {
    const auto& change = diff.changes[i];
    if (!change.is_difference()) continue;
    lines.push_back({change_kinds(change).front(), change_text(answer, change),
                     place_of(obstacle_of(answer, change)), i});
  }
  if (answer.navigation) add_navigation(*answer.navigation, lines);
  return lines;
}

std::string summary_line(const DiffAnswer& answer) {
  const auto& counts = answer.obstacles.counts;
  return formatted(
      "%zu added, %zu removed, %zu moved, %zu reshaped, %zu with other attributes, %zu unchanged",
      counts.added, counts.removed, counts.moved, counts.reshaped, counts.reattributed,
      counts.unchanged);
}

std::string renumbered_line(const DiffAnswer& answer) {
  std::size_t count = 0;
  for (const auto& change : answer.obstacles.changes) count += change.is_difference() ? 0 : 1;
  if (count == 0) return {};
  return counted(count, "obstacle") + (count == 1 ? " has" : " have") + " another number only";
}

}  // namespace mapwright::cli
