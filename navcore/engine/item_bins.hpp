// Private to this folder: square bins over the plane that know which items touch them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::navcore::engine {

/// What goes into a bin: a segment, or an area given by its box.
struct BinItem {
  Point a, b;  ///< ends of the segment, or opposite corners of the box
  bool is_area = false;

  static BinItem segment(Point a, Point b) { return {a, b, false}; }
  static BinItem area(const Box& box) {
    return {{box.min_x, box.min_y}, {box.max_x, box.max_y}, true};
  }
};

struct BinIndex {
  std::int32_t column = 0;
  std::int32_t row = 0;
};

/// A uniform grid over the items' extent with, for each bin, the numbers of the items that touch
/// it. Immutable once built; two passes of counting and filling, about four items a bin.
class ItemBins {
 public:
  ItemBins() = default;
  explicit ItemBins(std::span<const BinItem> items);

  /// Calls `visit(item)` for the items of every bin that touches `box`; an item may come more than
  /// once.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    if (is_empty()) return;
    const BinIndex low = clamped({box.min_x, box.min_y});
    const BinIndex high = clamped({box.max_x, box.max_y});
    for (std::int32_t row = low.row; row <= high.row; ++row) {
      for (std::int32_t column = low.column; column <= high.column; ++column) {
        for (const std::uint32_t item : items({column, row})) visit(item);
      }
    }
  }

  bool is_empty() const { return items_.empty(); }
  double bin_size_m() const { return size_m_; }
  Point corner() const { return corner_; }  ///< lower left, of bin (0, 0)
  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }

  /// Items of one bin. Requires a bin of the grid.
  std::span<const std::uint32_t> items(BinIndex bin) const {
    const std::size_t i = offset(bin);
    return std::span(items_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }

  /// The bin that holds p, or the nearest one.
  BinIndex clamped(Point p) const;

  std::size_t memory_bytes() const {
    return (starts_.capacity() + items_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  std::size_t offset(BinIndex bin) const {
    return static_cast<std::size_t>(bin.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(bin.column);
  }
  void lay_out(const Box& extent, std::size_t items);
  template <class Visit>
  void for_each_bin(const BinItem& item, Visit&& visit) const;

  Point corner_;
  double size_m_ = 1.0;
  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  std::vector<std::uint32_t> starts_;  ///< bins + 1
  std::vector<std::uint32_t> items_;
};

}  // namespace mapwright::navcore::engine
