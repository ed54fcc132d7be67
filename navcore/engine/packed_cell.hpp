// Private to this folder: the list of a cell as the kernels read it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "navcore/engine/aligned.hpp"
#include "navcore/engine/cell_walls.hpp"

namespace mapwright::navcore::engine {

/// Some segments of a cell's list, one after the other.
struct SegmentRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The segments of a staircase.
struct PackedStairs {
  SegmentRun tops, low_steps, stops;
};

/// CellWalls in one piece of memory, as few cache lines as can be: this header, the staircases, and
/// the ends of the segments in single precision relative to the cell's centre, for each run
/// ax[count] ay[count] bx[count] by[count]; then what is needed less often. A vector may be read
/// that begins in a run and ends beyond it.
struct PackedCell {
  std::uint32_t size = 0;  ///< segments of all runs

  /// The first run: walls, then a lone staircase's stops from first_stop on, and its tops from
  /// first_top on. A staircase is lone if it is the only one and no low steps matter: the rule of
  /// figure 6 needs no ranges then apart from the scan's.
  std::uint32_t two_sided_count = 0;
  std::uint32_t first_stop = 0;
  std::uint32_t first_top = 0;

  std::uint32_t one_sided_count = 0;  ///< the second run
  std::uint32_t stairs_count = 0;     ///< staircases that are not lone

  SegmentRun two_sided() const { return {0, two_sided_count}; }
  SegmentRun one_sided() const { return {two_sided_count, one_sided_count}; }
  std::span<const PackedStairs> stairs() const {
    return {reinterpret_cast<const PackedStairs*>(this + 1), stairs_count};
  }

  /// ax of the first segment; ay, bx and by are run.count further each.
  const float* ends(SegmentRun run) const { return floats() + std::size_t{4} * run.first; }

  /// What the segment is: an item of the scene.
  std::uint32_t item(std::uint32_t segment) const {
    return reinterpret_cast<const std::uint32_t*>(floats() + std::size_t{4} * size)[segment];
  }

 private:
  const float* floats() const {
    return reinterpret_cast<const float*>(stairs().data() + stairs_count);
  }
};

/// Bytes that `pack` writes.
std::size_t packed_size(const CellWalls& walls);

/// Bytes of a packed list, its header included.
std::size_t packed_size(const PackedCell& cell);

/// Writes the packed list to `memory`, which must hold packed_size(walls) bytes and be aligned to a
/// line.
const PackedCell* pack(const CellWalls& walls, std::byte* memory);

}  // namespace mapwright::navcore::engine
