// Private to this folder: what stops rays that start in one cell.
#pragma once

#include <cstdint>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::navcore::engine {

/// A segment that rays from a cell may meet, relative to the cell's centre, cut where no ray from
/// the cell reaches.
struct CellWall {
  Point a, b;
  std::uint32_t item = 0;  ///< segment of the scene, or ramp
};

/// The segments of one staircase that matter from a cell (report, section 4.1, figure 6).
struct CellStairs {
  std::vector<CellWall> stops;      ///< higher than the laser
  std::vector<CellWall> low_steps;  ///< higher than 0 but not higher than the laser
  std::vector<CellWall> tops;       ///< of height 0
};

/// Everything that rays from a cell may meet: a superset of what they do meet, without what is out
/// of range or hidden from all of the cell.
struct CellWalls {
  std::vector<CellWall> two_sided;
  std::vector<CellWall> one_sided;  ///< contours of ramps: stop rays from the left of a→b only
  std::vector<CellStairs> stairs;   ///< those a robot may look at from above
};

}  // namespace mapwright::navcore::engine
