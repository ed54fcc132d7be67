// Private to this folder: the lists of the cells that were visited lately.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "navcore/engine/cell_compiler.hpp"
#include "navcore/engine/packed_cell.hpp"
#include "navcore/engine/piece_poses.hpp"

namespace mapwright::navcore::engine {

/// A cell of the grid.
struct CellKey {
  std::int32_t column = 0;
  std::int32_t row = 0;

  friend bool operator==(const CellKey&, const CellKey&) = default;
};

inline std::size_t hash_of(CellKey key) {
  const std::uint64_t both = std::uint64_t{static_cast<std::uint32_t>(key.column)} |
                             std::uint64_t{static_cast<std::uint32_t>(key.row)} << 32U;
  return both * 0x9e3779b97f4a7c15U >> 32U;
}

/// floor(x), without the library call that the baseline instruction set needs for it.
inline std::int32_t whole_cells(double x) {
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (x < truncated ? 1 : 0);
}

/// Memory that is only ever freed as a whole.
class Arena {
 public:
  /// Aligned to a line; of the line that follows, too, anything may be read.
  std::byte* allocate(std::size_t bytes);
  std::size_t bytes() const { return bytes_; }  ///< taken from the system

 private:
  struct Release {
    void operator()(std::byte* p) const;
  };
  std::vector<std::unique_ptr<std::byte, Release>> chunks_;
  std::size_t left_ = 0;
  std::byte* next_ = nullptr;
  std::size_t bytes_ = 0;
};

/// Hash table from cells to their lists (open addressing).
class CellTable {
 public:
  CellTable() : slots_(kFirstSlots) {}

  /// Where the cell's list is, or would be.
  std::size_t slot_of(CellKey key) const {
    std::size_t i = home(key);
    while (slots_[i].cell != nullptr && !(slots_[i].key == key)) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  const PackedCell* cell_in(std::size_t slot) const { return slots_[slot].cell; }
  std::size_t slots() const { return slots_.size(); }

  const PackedCell* find(CellKey key) const { return cell_in(slot_of(key)); }
  void insert(CellKey key, const PackedCell* cell);  ///< requires that it is not in yet
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }

 private:
  static constexpr std::size_t kFirstSlots = 64;

  struct Slot {
    CellKey key;
    const PackedCell* cell = nullptr;
  };
  std::size_t home(CellKey key) const { return hash_of(key) & (slots_.size() - 1); }
  void grow();

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

/// Lists of cells, compiled when first asked for and kept within a budget.
///
/// Two generations: when the young one has filled half of the budget it becomes the old one, and
/// the former old one is freed; what is found in the old one moves to the young one. So what was
/// used lately stays, and nothing is freed piece by piece.
///
/// `table` may be read by many threads at once; `compile_missing` may be called from one, and not
/// meanwhile.
class CellCache {
 public:
  CellCache(const Scene& scene, const Reach& reach, std::size_t budget_bytes);

  const CellGrid& grid() const { return grid_; }

  /// True if cells have numbers at p.
  bool has_cell(Point p) const {
    return std::abs(p.x) < grid_.most_m && std::abs(p.y) < grid_.most_m;
  }

  /// The cell that p is in. Requires has_cell(p).
  CellKey key_of(Point p) const {
    return {whole_cells(p.x * grid_.cells_per_metre), whole_cells(p.y * grid_.cells_per_metre)};
  }

  /// The centre of the cell.
  Point center_of(CellKey key) const {
    return {(key.column + 0.5) * reach_.cell_size_m, (key.row + 0.5) * reach_.cell_size_m};
  }

  /// The lists of the young cells.
  const CellTable& table() const { return young_.table; }

  /// Makes all these cells young, until the next call; repeated keys are welcome. Compiles by
  /// up to `threads` threads.
  void compile_missing(std::span<const CellKey> keys, unsigned threads);

  /// Holds no walls: for poses so far off that cells have no numbers there.
  const PackedCell* nowhere() const { return nowhere_; }

  std::size_t memory_bytes() const;
  std::size_t cells() const { return young_.table.size() + old_.table.size(); }

 private:
  struct Generation {
    Arena arena;
    CellTable table;

    std::size_t bytes() const { return arena.bytes() + table.bytes(); }
  };

  void make_room();
  bool keep_if_old(CellKey key);
  void compile(std::span<const CellKey> keys, unsigned threads);

  const Scene* scene_;
  Reach reach_;
  CellGrid grid_;
  std::size_t budget_bytes_;
  Generation young_, old_;
  Arena always_;
  const PackedCell* nowhere_;
};

}  // namespace mapwright::navcore::engine
