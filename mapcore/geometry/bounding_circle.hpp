// Minimum bounding circles (report, section 4.1, and its reference [7]).
#pragma once

#include <span>

#include "mapcore/map.hpp"

namespace mapwright {

struct Circle {
  Point center;           ///< metres, map frame
  double radius_m = 0.0;  ///< negative for the circle that contains nothing
};

/// Smallest circle around the points, its radius rounded up so that every point truly lies inside:
/// distance(center, p) <= radius_m holds in double arithmetic for each. Radius −1 for no points.
Circle min_bounding_circle(std::span<const Point> points);

/// The same around all end points of an obstacle's segments.
Circle min_bounding_circle(const Obstacle& obstacle);

}  // namespace mapwright
