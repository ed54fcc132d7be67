// Simple outlines out of rings that cross or touch themselves.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

/// A polygon of simple rings: the outer one counter-clockwise, the holes clockwise.
struct SimplePolygon {
  std::vector<Point> outer;
  std::vector<std::vector<Point>> holes;
};

/// Moves a point to where it will be written.
using Snap = std::function<Point(Point)>;

/// The area that the rings cover an odd number of times, as polygons of simple rings; nothing where
/// there is none. Nothing at all (nullopt) if rounding keeps making rings touch themselves.
///
/// Exact constrained Delaunay triangulation of the edges, with their crossings, and the odd-even
/// rule; then every vertex is snapped, and the same is done again until snapping leaves all rings
/// simple. Requires finite points that `snap` leaves where they are.
std::optional<std::vector<SimplePolygon>> odd_even_polygons(
    std::span<const std::vector<Point>> rings, const Snap& snap);

/// True if the chain has no zero-length segment and does not cross or retrace itself. It may touch
/// itself at single points, as a fence does that ends at its own middle.
bool is_simple_chain(std::span<const Point> chain);

/// Cuts an open chain that crosses or retraces itself into chains that do not, which run the same
/// way. The chain may end where it began. Requires finite points that `snap` leaves where they are.
std::optional<std::vector<std::vector<Point>>> simple_chains(std::vector<Point> chain,
                                                             const Snap& snap);

}  // namespace mapwright
