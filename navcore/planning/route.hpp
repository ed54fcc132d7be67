// Paths through several places.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/planning/planner.hpp"
#include "navcore/planning/smoothing.hpp"

namespace mapwright::navcore {

/// Plans from one stop to the next; any planner.
using LegPlanner = std::function<PlanningResult(const PlanQuery&, Random&)>;

struct Route {
  /// Of all legs together: paths joined, iterations summed, trees one after the other, the
  /// narrowest bottleneck. Not solved as soon as one leg is not; the path is empty then.
  PlanningResult total;
  std::vector<Point> raw_path;  ///< before smoothing
  std::size_t failed_leg = 0;   ///< 1-based number of the leg that was not solved; 0 for none
};

/// A path through all stops in turn (start, via-points, goal; at least two). Each leg is smoothed
/// on its own, so that via-points stay on the path, unless `smoothing` is absent or the planner's
/// path is the shortest. Leg i draws its random numbers from streams 2i and 2i + 1 of the seed.
///
/// Requires every stop free for the radius.
Route plan_route(const FreeSpace& space, std::span<const Point> stops, double radius_m,
                 const LegPlanner& plan_leg, const std::optional<SmoothingOptions>& smoothing,
                 std::uint64_t seed);

/// A point on the ramp's footprint that is free for the radius, from which a path can be forced
/// across the ramp: of the footprint's centre and 64 points of it the one with the greatest
/// clearance. Nothing where none is free.
std::optional<Point> point_on_ramp(const FreeSpace& space, const Obstacle& ramp, double radius_m);

}  // namespace mapwright::navcore
