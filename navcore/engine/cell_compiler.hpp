// Private to this folder: finds what stops rays that start in one cell.
#pragma once

#include "navcore/engine/cell_walls.hpp"
#include "navcore/engine/planar.hpp"
#include "navcore/engine/scene.hpp"

namespace mapwright::navcore::engine {

/// What the lists of cells depend on.
struct Reach {
  double height_m = 0.0;     ///< hL
  double max_range_m = 0.0;  ///< RMAX
  double cell_size_m = 0.0;

  friend bool operator==(const Reach&, const Reach&) = default;
};

/// Lists for the square cell around `center` the segments that a ray from any of its points can
/// meet first. Exact for every pose in the cell, inside of solids too: a segment is left out only
/// where each ray to it is stopped before, or where it is out of range.
///
/// 1. Segments and ramps out of range, and segments not higher than the laser, are dropped.
/// 2. Of a simple ring that lies clear of the cell, the segments whose far side faces the cell are
///    dropped: to reach one, a ray has to cross the ring before.
/// 3. What one wall, or one chain of walls, hides from all of the cell is dropped (Umbra).
CellWalls compile_cell(const Scene& scene, const Reach& reach, Point center);

}  // namespace mapwright::navcore::engine
