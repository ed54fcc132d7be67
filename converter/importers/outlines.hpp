// Private to this folder: outlines of the occupied cells of a grid.
#pragma once

#include <cstdint>
#include <vector>

#include "converter/importers/occupancy_grid.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

/// A closed ring in units of half a cell: the centre of cell (column, row) lies at (2 column, 2
/// row).
using LatticeRing = std::vector<Point>;

/// Marching squares: rings through the middles of the lines between centres of occupied and other
/// cells, counter-clockwise around occupied cells and clockwise around what they enclose. Cells
/// that touch at a corner are joined, so that a slanting wall has no holes. All rings are simple,
/// and no two of them touch. They keep within 0.36 cells of the outlines of the cells themselves,
/// which have corners where these have chamfers.
std::vector<LatticeRing> occupied_outlines(const OccupancyGrid& grid);

}  // namespace mapwright::converter
