// How far two drawings are from each other at most.
#pragma once

#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

/// A line from a to b.
struct DrawnEdge {
  Point a, b;
};

/// Edges of a ring (closed) or of a chain.
std::vector<DrawnEdge> edges_of(std::span<const Point> points, bool closed);

/// Hausdorff distance of two sets of edges, metres: the greatest distance from a point of either
/// set to the other set. Never less than the true one, and more by `slack_m` at most. Infinite if
/// exactly one set is empty.
///
/// Bisection: on an edge the distance to the set is at most the distance to the one edge that is
/// nearest to its middle, and that is convex, so greatest at an end. n log n for drawings that are
/// near each other.
double hausdorff_distance_m(const std::vector<DrawnEdge>& first,
                            const std::vector<DrawnEdge>& second, double slack_m);

}  // namespace mapwright
