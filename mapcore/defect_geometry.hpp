// The shapes that findings show.
#pragma once

#include <span>

#include "mapcore/finding.hpp"
#include "mapcore/map.hpp"

namespace mapwright {

/// The segment as a line; as a point where it has no length.
DefectGeometry geometry_of(const Segment& segment);

/// The segments as lines, each as long as segments join.
DefectGeometry geometry_of(std::span<const Segment> segments);

/// The obstacle: a closed shape that closes as an area, any other as the lines of its segments.
DefectGeometry geometry_of(const Obstacle& obstacle);

/// The border as an area; as lines where its corners coincide in x or y.
DefectGeometry geometry_of(const Border& border);

/// Adds the parts of `other`.
void append(DefectGeometry& geometry, DefectGeometry other);

}  // namespace mapwright
