#include "cli/plan/places.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"

namespace mapwright::cli {
namespace {

std::string number_text(double value) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {std::begin(buffer), result.ptr};
}

double to_millimetre(double metres) {
  return std::round(metres * 1000.0) / 1000.0;
}

std::string metres_text(double metres) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f m", metres);
  return buffer;
}

double distance_to_border_m(const Border& border, Point p) {
  return std::min(std::min(p.x - border.left, border.right - p.x),
                  std::min(p.y - border.bottom, border.top - p.y));
}

bool fits_nowhere(const Border& border, double radius_m) {
  return 2.0 * radius_m > std::min(border.right - border.left, border.top - border.bottom);
}

std::int64_t parse_id(const std::string& option, const std::string& text) {
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size()) {
    fail_usage("--" + option + ": '" + text + "' is not the id of a ramp");
  }
  return id;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

std::string unknown_name(const std::vector<navcore::NamedPlace>& places, const std::string& name) {
  constexpr std::size_t kMostNames = 100;
  std::string message = "the map has no place named '" + name + "'";
  if (places.empty()) return message + ": none of its obstacles has a name; a point is x,y";
  const auto similar = navcore::similar_names(places, name);
  if (!similar.empty()) message += "; did you mean " + quoted_list(similar) + "?";
  std::vector<std::string> names;
  for (const auto& place : places) names.push_back(place.name);
  const std::size_t more = names.size() - std::min(names.size(), kMostNames);
  names.resize(names.size() - more);
  message += "\nIts places: " + quoted_list(names);
  return more == 0 ? message : message + " and " + std::to_string(more) + " more";
}

}  // namespace

std::string place_text(Point p) {
  return "(" + number_text(p.x) + ", " + number_text(p.y) + ")";
}

std::string obstacle_text(const Obstacle& obstacle) {
  std::string text = "obstacle " + std::to_string(obstacle.id);
  if (!obstacle.semantic.empty()) text += " (" + obstacle.semantic.str() + ")";
  return text;
}

std::optional<std::string> why_not_standing(const Map& map, const navcore::FreeSpace& space,
                                            Point p, double radius_m, const std::string& what) {
  if (space.is_free(p, radius_m)) return std::nullopt;
  const std::string place = what + " " + place_text(p);
  const std::string robot = "a robot of radius " + number_text(radius_m) + " m";
  if (fits_nowhere(map.border, radius_m)) {
    return robot + " does not fit within the map's border, " +
           number_text(to_millimetre(map.border.right - map.border.left)) + " m by " +
           number_text(to_millimetre(map.border.top - map.border.bottom)) + " m";
  }
  if (!map.border.contains(p)) return place + " lies outside of the map's border";
  if (const auto solid = space.solid_at(p)) {
    const Obstacle& obstacle = map.obstacles[*solid];
    const bool within = extent(obstacle).contains(p) && obstacle.segments.size() > 1;
    return place + (within ? " lies in " : " lies outside of the rooms of the map, behind ") +
           obstacle_text(obstacle);
  }
  const double to_border_m = distance_to_border_m(map.border, p);
  const auto nearest = space.index().nearest(p);
  if (!nearest || to_border_m < nearest->distance_m) {
    return place + " is " + metres_text(to_border_m) + " from the map's border, too near for " +
           robot;
  }
  const Obstacle& obstacle = map.obstacles[space.index()[nearest->segment].tag];
  return place + " is " + metres_text(nearest->distance_m) + " from " + obstacle_text(obstacle) +
         ", too near for " + robot;
}

std::string place_text(const Place& place) {
  if (place.name.empty()) return place_text(*place.at);
  const std::string name = "'" + place.name + "'";
  return place.at ? name + " " + place_text(*place.at) : name;
}

Place parse_place(const std::string& option, const std::string& text) {
  if (text.empty() || text.find(',') != text.npos) return {parse_point(option, text), {}};
  return {std::nullopt, text};
}

const navcore::NamedPlace& find_place(const navcore::PlaceFinder& finder, const std::string& name) {
  const navcore::NamedPlace* place = finder.find(name);
  if (place == nullptr) fail_usage(unknown_name(finder.places(), name));
  return *place;
}

ViaPlace parse_via(const std::string& option, const std::string& text) {
  constexpr std::string_view kRamp = "ramp:";
  if (!text.starts_with(kRamp)) return {std::nullopt, parse_place(option, text)};
  return {parse_id(option, text.substr(kRamp.size())), {}};
}

}  // namespace mapwright::cli
