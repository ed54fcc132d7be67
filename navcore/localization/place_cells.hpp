// Places: a grid over the poses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/angle.hpp"

namespace mapwright::navcore {

/// A cell of 1 m × 1 m × 20°, by its numbers.
using PlaceCell = std::array<std::int64_t, 3>;

PlaceCell place_cell(const Pose& pose);

/// Poses in order of place (those of one cell as they came), and where each cell's begin.
struct CellOrder {
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> begins;  ///< into `order`; the last is its size
};

CellOrder sorted_into_cells(std::span<const Pose> poses);

}  // namespace mapwright::navcore
