// Private to this folder: poses as the kernels want them.
#pragma once

#include <cstdint>
#include <span>

#include "mapcore/angle.hpp"
#include "navcore/engine/packed_cell.hpp"

namespace mapwright::navcore::engine {

/// Where some scans start: those in one cell follow each other, since they share work.
struct ScanStarts {
  /// The starts first, first + 1, …
  struct InCell {
    const PackedCell* cell = nullptr;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  std::span<const InCell> cells;

  /// By start; a block more than there are starts may be read.
  const float* x = nullptr;  ///< metres, relative to the cell's centre
  const float* y = nullptr;
  const float* cosine = nullptr;  ///< of the heading
  const float* sine = nullptr;

  const std::uint32_t* scan = nullptr;  ///< by start: which pose it is, and which result
  const Pose* poses = nullptr;          ///< by scan
};

}  // namespace mapwright::navcore::engine
