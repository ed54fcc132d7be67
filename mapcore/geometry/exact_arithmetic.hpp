// Private to this folder: What doubles cannot decide: the slow, exact answers behind the filters.
#pragma once

#include <span>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::exact {

/// Side of p as seen from a towards b.
Turn turn(Point a, Point b, Point p);

/// Sign of the ring's signed area.
int area_sign(std::span<const Point> ring);

/// The point in which the lines ab and cd cross, moved to doubles at the end. Requires lines that
/// are not parallel.
Point crossing(Point a, Point b, Point c, Point d);

/// True if the polygon is simple, by a plane sweep. Requires at least three vertices, none of them
/// twice.
bool is_simple(std::span<const Point> ring);

}  // namespace mapwright::exact
