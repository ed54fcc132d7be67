// Start, goal and what lies between: whether a robot can stand there, and why not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"
#include "navcore/named_places.hpp"

namespace mapwright::cli {

/// "(1.5, -2)", as short as the numbers read back.
std::string place_text(Point p);

/// "obstacle 7 (column,A5)".
std::string obstacle_text(const Obstacle& obstacle);

/// Why the robot cannot stand at p: outside of the border, in an obstacle, or too near to one,
/// which is named; nothing where it can. `what` begins the sentence: "start (1, 2) lies in obstacle
/// …".
std::optional<std::string> why_not_standing(const Map& map, const navcore::FreeSpace& space,
                                            Point p, double radius_m, const std::string& what);

/// A place as it is asked for: a point, or the name of a place of the map (its point is found when
/// the map is there, and stays away where the robot has no room beside it).
struct Place {
  std::optional<Point> at;
  std::string name;  ///< empty for a point
};

struct StartAndGoal {
  Place start, goal;
};

/// "(1.5, -2)", or "'Library' (1.5, -2)".
std::string place_text(const Place& place);

/// "x,y" or a name, which has no comma. Throws Error (kUsage).
Place parse_place(const std::string& option, const std::string& text);

/// The place of that name. Throws Error (kUsage) that lists similar names, or all.
const navcore::NamedPlace& find_place(const navcore::PlaceFinder& finder, const std::string& name);

/// A place the path must pass: a place, or somewhere on the ramp with an id.
struct ViaPlace {
  std::optional<std::int64_t> ramp;
  Place place;
};

/// "x,y", a name or "ramp:ID". Throws Error (kUsage).
ViaPlace parse_via(const std::string& option, const std::string& text);

}  // namespace mapwright::cli
