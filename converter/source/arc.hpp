// Circular arcs as chords.
#pragma once

#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Appends the points after `a` of the arc from a over b to c, c included (and b, so that the given
/// points stay). No chord is farther from the arc than `sagitta` (> 0, in the unit of the points).
/// An arc with c == a is the full circle with b opposite of a (ISO 19125 / SQL-MM). Where the three
/// points lie on a line, the arc is the line a, b, c.
///
/// The two halves are divided evenly, so that a shared arc drawn backwards gives the same points.
void append_arc(Point a, Point b, Point c, double sagitta, std::vector<Point>& points);

}  // namespace mapwright::converter
