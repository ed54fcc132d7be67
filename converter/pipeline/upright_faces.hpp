// Faces that stand upright: seen from above they are lines.
#pragma once

#include <cstddef>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/geometry/ring_repair.hpp"

namespace mapwright::converter {

/// A wall along the footprint of a face.
struct UprightFace {
  std::vector<std::size_t> paths;  ///< positions of its rings
  std::vector<Point> line;         ///< at the map's resolution, open
  bool curved = false;
  bool has_openings = false;  ///< inner rings, or doorways cut out of a straight face
  double bottom_m = 0.0, top_m = 0.0;
};

/// The outlines and closed lines of a geometry (in the map frame, heights in metres) that cover no
/// more ground than `resolution_m` tells apart and stand higher than a step. One whose footprint is
/// bent may come as several. Those of one footprint line come once, from the lowest bottom to the
/// highest top.
std::vector<UprightFace> upright_faces(const SourceGeometry& geometry, double resolution_m,
                                       const Snap& snap);

}  // namespace mapwright::converter
