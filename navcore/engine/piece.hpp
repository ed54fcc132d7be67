// Private to this folder: a few poses on their way to the kernels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "navcore/engine/cell_cache.hpp"
#include "navcore/engine/kernels.hpp"
#include "navcore/engine/piece_poses.hpp"

namespace mapwright::navcore::engine {

/// Sorts a few poses by cell. No step waits for a branch that hangs on what cell a pose is in.
class Piece {
 public:
  static constexpr std::size_t kMost = kMostPoses;

  /// Requires at most kMost poses, which must outlive this, and nothing but zeros in `marks`, which
  /// is this object's own as long as it lives.
  Piece(std::span<const Pose> poses, const CellCache& cells, std::vector<std::uint16_t>& marks);
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;
  ~Piece();

  /// False if some pose's cell has no list yet.
  bool find_cells(const Kernels& kernels);

  /// `scan` counts the poses from 0. Requires that find_cells() was true. Valid as long as this.
  ScanStarts starts(const Kernels& kernels, const BeamTable& beams);

 private:
  /// A cell that poses are in: where the next start goes.
  struct Visited {
    std::uint32_t count, grouped, first_grouped, first_alone;
  };

  void visit(std::size_t pose, const PackedCell* cell, std::uint16_t& mark, std::size_t slot);
  void share_out(GroupSize size);

  std::span<const Pose> poses_;
  const CellCache& cells_;
  std::vector<std::uint16_t>& marks_;  ///< by slot of the cells' table: number in `visited_`, or 0
  std::uint16_t nowhere_mark_ = 0;
  std::size_t used_ = 1;
  std::size_t alone_count_ = 0, group_count_ = 0;
  // The rest is written before it is read.
  std::array<Visited, kMost + 2> visited_;  ///< from 1 on
  std::array<const PackedCell*, kMost + 2> cell_;
  std::array<std::uint32_t, kMost + 2> slot_;
  std::array<std::uint16_t, kMost> visited_by_;  ///< by scan
  std::array<StartInCell, kMost> alone_;
  std::array<ScanStarts::InCell, kMost + 2> groups_;
  alignas(kLine) std::array<float, kMost + kBlock> x_, y_, cosine_, sine_;  ///< by start
  std::array<std::uint32_t, kMost> scan_;
  PiecePoses places_;
};

}  // namespace mapwright::navcore::engine
