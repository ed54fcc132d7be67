// The area that several polygons cover together.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mapcore/geometry/ring_repair.hpp"

namespace mapwright {

/// Union of polygons as polygons of simple rings, vertices snapped, straight ones left out
/// (CGAL's regularized Boolean set operations, exact). Nothing (nullopt) where rounding leaves
/// rings that cannot be made simple. Requires polygons whose holes lie within their outlines and do
/// not meet each other.
std::optional<std::vector<SimplePolygon>> united_polygons(std::span<const SimplePolygon> polygons,
                                                          const Snap& snap);

}  // namespace mapwright
