// Private to this folder: Whether a path of a point passes walls that touch it.
#pragma once

#include <span>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// True if the path gets from one side of walls that hang together to the other where it touches
/// them: through a point that two of them share, or by stepping on a wall and off on its other
/// side. Around a point that walls touch, they cut the plane into sectors; a path must leave by the
/// sector it came in, and on a wall it stays on its side. Sees nothing of legs that cross a wall at
/// a point inside of both. The border counts as a wall. Exact; every point of the path is compared
/// with every wall. Requires a path within the border.
bool passes_where_it_touches(const Border& border, std::span<const BlockingSegment> segments,
                             std::span<const Point> path);

}  // namespace mapwright::navcore
