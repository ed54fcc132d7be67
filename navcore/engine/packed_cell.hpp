// Private to this folder: the list of a cell as the kernels read it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mapcore/point.hpp"
#include "navcore/engine/aligned.hpp"
#include "navcore/engine/cell_walls.hpp"

namespace mapwright::navcore::engine {

/// Some lanes of a cell's list; they begin with a block.
struct LaneRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

/// The lanes of a staircase: tops first, then low steps, then stops.
struct PackedStairs {
  LaneRun lanes;
  std::uint32_t first_low_step = 0;
  std::uint32_t first_stop = 0;

  bool is_top(std::uint32_t lane) const { return lane < first_low_step; }
  bool is_stop(std::uint32_t lane) const { return lane >= first_stop; }
};

/// CellWalls in one piece of memory: this header, then the ends of the segments in single precision
/// relative to the cell's centre, in blocks ax[16] ay[16] bx[16] by[16], then what is needed less
/// often. Lanes that pad a block hold segments of no length.
struct alignas(kLine) PackedCell {
  Point center;
  std::uint32_t lanes = 0;  ///< of all blocks
  LaneRun two_sided, one_sided;
  std::uint32_t stairs_count = 0;

  const float* block(std::uint32_t lane) const {
    return reinterpret_cast<const float*>(this + 1) + lane / kBlock * (4 * kBlock);
  }
  /// What the lane's segment is: an item of the scene.
  std::uint32_t item(std::uint32_t lane) const { return items()[lane]; }
  std::span<const PackedStairs> stairs() const {
    return {reinterpret_cast<const PackedStairs*>(items() + lanes), stairs_count};
  }

 private:
  const std::uint32_t* items() const {
    return reinterpret_cast<const std::uint32_t*>(block(lanes));
  }
};

/// Bytes that `pack` writes.
std::size_t packed_size(const CellWalls& walls);

/// Bytes of a packed list, its header included.
std::size_t packed_size(const PackedCell& cell);

/// Writes the packed list to `memory`, which must hold packed_size(walls) bytes and be aligned to a
/// line.
const PackedCell* pack(const CellWalls& walls, Point center, std::byte* memory);

}  // namespace mapwright::navcore::engine
