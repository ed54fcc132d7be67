// Geometry collections taken apart.
#pragma once

#include <vector>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// The polygons, the lines and the points of a geometry, each kind that there is as a geometry of
/// its own, in that order. The type of a part that no path stands for stays with the first.
std::vector<SourceGeometry> parts_by_kind(const SourceGeometry& geometry);

}  // namespace mapwright::converter
