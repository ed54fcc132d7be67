// Occupancy grids, as map servers of robots read them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

enum class Cell : std::uint8_t { kFree, kUnknown, kOccupied };

/// Square cells, row by row from the bottom, each row from left to right.
struct OccupancyGrid {
  std::size_t columns = 0, rows = 0;
  double resolution_m = 0.05;  ///< side of a cell
  Pose origin;                 ///< of the lower left corner of the first cell, map frame
  std::vector<Cell> cells;

  Cell at(std::size_t column, std::size_t row) const { return cells[row * columns + column]; }
};

/// Reads the YAML file of a map server (ROS map_server, nav2) and the image it names (PGM, PNG,
/// BMP; grey, or the mean of the colours). Keys: image, resolution, origin [x, y, yaw], negate,
/// occupied_thresh, free_thresh, mode (trinary and scale classify alike; raw takes pixels for
/// percent). The image's path is relative to the YAML file.
///
/// Fails (kInput) with the place in the file.
Result<OccupancyGrid> read_grid_map(const std::string& yaml_path);

}  // namespace mapwright::converter
