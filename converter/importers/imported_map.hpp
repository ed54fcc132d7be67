// Robot maps out of what other robots' programs call maps: tables of lines, occupancy grids.
#pragma once

#include <span>

#include "converter/importers/occupancy_grid.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

/// What such maps do not say.
struct ImportOptions {
  double height_m = 2.0;  ///< of every segment
  InOut in_out = InOut::kIndoor;
  double border_margin_m = 1.0;  ///< around everything

  double simplification_m = 0.05;  ///< grids: outlines move by this at most, see grid_to_map
  double smallest_area_m2 = 0.0;   ///< grids: outlines of less are left out
};

struct Line {
  Point a, b;
};

/// Each line becomes an open wall of one segment, free on both sides. Lines without length are left
/// out.
Map lines_to_map(std::span<const Line> lines, const ImportOptions& options);

/// The outlines of the occupied cells become closed polygons, what they enclose inner rings.
/// Unknown cells are taken for free: no wall has been seen there. Every point of the segments lies
/// within `simplification_m` + 0.36 cells of the outline of the occupied cells, and no two
/// obstacles touch.
Map grid_to_map(const OccupancyGrid& grid, const ImportOptions& options);

}  // namespace mapwright::converter
