// A second opinion on paths.
#pragma once

#include <span>

#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// Checks a path against the map's segments one by one; knows nothing of meshes.
///
/// Radius 0: no leg crosses a segment at a point inside of both, and where the path touches
/// segments it does not get to their other side: neither through a point that two of them share,
/// nor along one and off beyond it (exact, wall_passing.hpp). Touching and running along is
/// allowed. Greater radius: every leg keeps `radius_m` from every segment and from the border
/// (double precision, error below a nanometre). Every point must lie within the border. An empty
/// path is wrong.
bool is_path_clear(const Border& border, std::span<const BlockingSegment> segments,
                   std::span<const Point> path, double radius_m);

/// Least distance of the path to segments and border, metres.
double least_distance_m(const Border& border, std::span<const BlockingSegment> segments,
                        std::span<const Point> path);

}  // namespace mapwright::navcore
