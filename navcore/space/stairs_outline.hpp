// Private to this folder: the area that stairs cover.
#pragma once

#include <utility>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::navcore {

/// The two ends of a flight's flanks: from step to step on one side and on the other. Of
/// consecutive segments that run the same way the starts belong together and the ends; of opposed
/// ones (the closing segment is reversed) the start of one and the end of the other.
struct StairsFlanks {
  std::vector<Point> near_a;  ///< on the side of the first segment's a, one point per segment
  std::vector<Point> near_b;  ///< on the side of its b
};

StairsFlanks stairs_flanks(const Obstacle& stairs);

/// Ring around the flight: first segment, flank, last segment, flank. Empty for fewer than two
/// segments. Holds in both printed orders, bottom-up and top-down.
std::vector<Point> stairs_outline(const Obstacle& stairs);

}  // namespace mapwright::navcore
