// Private to this folder: doors that are drawn beside the wall they are in.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "converter/indoorgml/wall_lines.hpp"

namespace mapwright::converter {

using OpenLine = std::pair<Point, Point>;

/// What a door opens.
struct DoorFit {
  bool opens = false;           ///< some wall, if only the one that it lies on
  std::vector<OpenLine> faces;  ///< the door again, on faces of the wall that it does not lie on
  double farthest = 0.0;        ///< of those faces from the door
  std::vector<WallEdge> jambs;  ///< sides of the doorway through a thick wall; owned by a cell
};

struct DoorLimits {
  double tolerance = 0.0;  ///< as of WallRules
  double thickest = 0.0;   ///< wall that a door goes through, in the unit of the coordinates
  std::size_t cells = 0;   ///< owners below it are cells: their floors lie on their edges' right
};

/// Finds the two faces of the wall that a door is in: on either side the nearest edge that runs
/// along the door for half of it at least, with its floor on that side. They may be no farther from
/// the door, nor from each other, than walls are thick; else the nearer one is all.
/// `index`: of the edges.
DoorFit fit_door(const OpenLine& door, const std::vector<WallEdge>& edges,
                 const SegmentIndex& index, const DoorLimits& limits);

}  // namespace mapwright::converter
