// Private to this folder: rings with fewer vertices that stay near, simple and apart.
#pragma once

#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// Leaves out vertices of simple rings that have no point in common. Every vertex left out is
/// within `bound` of the edge that stands for it (Ramer 1972, Douglas and Peucker 1973), and the
/// rings still are simple and have no point in common: where leaving out would make them meet, the
/// bound is halved, at last to 0 (only vertices on straight lines go). A ring keeps three vertices
/// at least.
std::vector<std::vector<Point>> simplified_rings(const std::vector<std::vector<Point>>& rings,
                                                 double bound);

}  // namespace mapwright::converter
