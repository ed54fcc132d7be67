// Private to this folder: The free space of a map for a point.
#pragma once

#include <cstdint>
#include <vector>

#include "mapcore/map.hpp"
#include "navcore/exact/tessellation.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore::exact {

/// Line::source of the map's border.
inline constexpr std::uint32_t kBorderSource = UINT32_MAX;

/// The blocking segments and the four sides of the border, rounded to the grid; a line's source is
/// the position of its segment. Segments that no frame can hold must have been refused before.
std::vector<Line> map_lines(const Map& map, const std::vector<BlockingSegment>& segments,
                            const GridFrame& frame);

/// Cuts the plane along the lines and marks as free what lies within the border and in no solid
/// (rules of FreeSpace). Triangles that no line separates form a face, and a face is free as a
/// whole: one of its points is asked. Every line is a wall.
Tessellation tessellate(const Map& map, RampPolicy ramps, const GridFrame& frame,
                        const std::vector<Line>& lines);

}  // namespace mapwright::navcore::exact
