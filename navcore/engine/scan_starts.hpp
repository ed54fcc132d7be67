// Private to this folder: poses as the kernels want them.
#pragma once

#include <cstdint>
#include <span>

#include "mapcore/angle.hpp"
#include "navcore/engine/packed_cell.hpp"

namespace mapwright::navcore::engine {

/// One of the starts.
struct StartInCell {
  const PackedCell* cell;
  std::uint32_t start;
};

/// Where some scans start.
struct ScanStarts {
  /// The starts first, first + 1, …
  struct InCell {
    const PackedCell* cell = nullptr;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  /// Scans that share their cell with too few others: the starts 0, 1, …
  std::span<const StartInCell> alone;
  std::span<const InCell> groups;  ///< the others: those in one cell share work

  /// By start, aligned to a line; a block more than there are starts may be read.
  const float* x = nullptr;  ///< metres, relative to the cell's centre
  const float* y = nullptr;
  const float* cosine = nullptr;  ///< of the heading
  const float* sine = nullptr;

  const std::uint32_t* scan = nullptr;  ///< by start: which pose it is, and which result
  const Pose* poses = nullptr;          ///< by scan
};

}  // namespace mapwright::navcore::engine
