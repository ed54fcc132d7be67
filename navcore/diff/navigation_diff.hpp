// What a change of a map means to a robot: what it sees, where it gets, how long its ways are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

struct NavigationDiffSettings {
  double robot_radius_m = 0.3;
  RampPolicy ramps = RampPolicy::kFree;
  LaserModel laser;
  std::size_t scans = 200;          ///< from random places that are free in both maps
  double scan_tolerance_m = 0.05;   ///< ranges that differ by no more are the same
  std::size_t routes = 20;          ///< between random places, unless `places` are given
  double route_tolerance_m = 0.05;  ///< lengths that differ by no more are the same
  double min_area_m2 = 1.0;         ///< smaller areas are not told of
  std::vector<Point> places;        ///< routes between each two of these
  /// Where the maps are known to differ: more scans are taken, and half of the random routes begin,
  /// around these.
  std::vector<Box> focus;
  std::uint64_t seed = 1;
  unsigned threads = 1;  ///< 0: one a core. The outcome does not depend on it
};

/// A pose from which the laser sees something else.
struct ScanDifference {
  Pose pose;
  std::size_t rays = 0;     ///< that read differently
  double largest_m = 0.0;   ///< greatest difference of a range
  bool is_sampled = false;  ///< one of the random poses; otherwise taken where the maps differ
};

struct ScansDiff {
  std::size_t sampled = 0, sampled_changed = 0;  ///< all over the ground both maps leave free
  std::size_t focused = 0, focused_changed = 0;  ///< around what changed
  std::vector<ScanDifference> changed;
};

/// A pair of places with a way of another length, or with one in one of the maps only. Shortest
/// paths; empty where there is none.
struct RouteDifference {
  Point start, goal;
  std::optional<double> before_m, after_m;
  std::vector<Point> before, after;
};

struct RoutesDiff {
  std::size_t tried = 0;  ///< pairs that both maps can tell of
  std::size_t longer = 0, shorter = 0, impossible = 0, possible = 0;
  std::vector<RouteDifference> changed;
};

/// What became of parts of the ground between which the robot cannot travel.
struct AreaDifference {
  enum class Kind : std::uint8_t { kAppeared, kVanished, kSplit, kJoined };
  Kind kind = Kind::kAppeared;
  Point at;               ///< somewhere in the area
  double area_m2 = 0.0;   ///< of places for the robot's centre; of the whole before a split
  std::size_t parts = 1;  ///< that it was split into, or joined of
};

struct AreasDiff {
  std::size_t components_before = 0, components_after = 0;  ///< of at least the least area
  double free_before_m2 = 0.0, free_after_m2 = 0.0;         ///< places for the robot's centre
  std::vector<AreaDifference> changed;
};

struct NavigationDiff {
  ScansDiff scans;
  RoutesDiff routes;
  AreasDiff areas;

  bool same() const {
    return scans.changed.empty() && routes.changed.empty() && areas.changed.empty();
  }
};

/// Scans by the scan engine, routes and areas by the exact planner, from places that are free for
/// the robot in both maps. Failures: those of ExactPlanner::build.
Result<NavigationDiff> diff_navigation(const Map& before, const Map& after,
                                       const NavigationDiffSettings& settings);

}  // namespace mapwright::navcore
