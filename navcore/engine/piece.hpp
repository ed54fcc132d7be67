// Private to this folder: a few poses on their way to the kernels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "navcore/engine/cell_cache.hpp"
#include "navcore/engine/kernels.hpp"

namespace mapwright::navcore::engine {

/// Sorts a few poses by cell.
class Piece {
 public:
  /// Poses prepared and cast together: what is known of them stays in the first-level cache.
  static constexpr std::size_t kMost = 512;

  /// Requires at most kMost poses, which must outlive this.
  Piece(std::span<const Pose> poses, const CellCache& cells);

  /// False if some pose's cell has no list yet.
  bool find_cells();

  /// `scan` counts the poses from 0. Requires that find_cells() was true. Valid as long as this.
  ScanStarts starts(const Kernels& kernels);

 private:
  using InCell = ScanStarts::InCell;
  static constexpr std::size_t kSlots = 4 * kMost;  // a power of two

  bool add(std::size_t pose, CellKey key);
  void turn(const Kernels& kernels);

  std::span<const Pose> poses_;
  const CellCache& cells_;
  std::size_t used_ = 1;                       ///< cells; the first is nowhere
  std::array<std::uint16_t, kSlots> slots_{};  ///< hash table of cells; 0: free
  // The rest is written before it is read.
  std::array<InCell, kMost + 1> in_cell_;
  std::array<CellKey, kMost + 1> key_;
  std::array<Point, kMost + 1> center_;  ///< those of the lists, without a look at the lists
  std::array<std::uint16_t, kMost> cell_of_;  ///< by scan
  std::array<double, kMost> cosine_of_, sine_of_;
  std::array<float, kMost + kBlock> x_, y_, cosine_, sine_;  ///< by start
  std::array<std::uint32_t, kMost> scan_;
};

}  // namespace mapwright::navcore::engine
