// Private to this folder: Boxes sorted into the cells of a grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/geometry/packed_tree.hpp"
#include "mapcore/point.hpp"

namespace mapwright {

/// Boxes, each grown by a reach on all sides, by the cells they meet: a counting sort into two flat
/// arrays. The boxes must outlive the grid.
class BoxGrid {
 public:
  BoxGrid(std::span<const Box> boxes, double reach_m);

  /// False where boxes of very different sizes meet too many cells, or too many share one, for a
  /// grid to pay; it is left empty then.
  bool pays() const { return pays_; }

  /// Calls `visit(i, j)`, i < j, once for each pair of grown boxes that meet.
  template <class Visit>
  void for_each_meeting_pair(const Visit& visit) const {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < columns_; ++column) visit_cell(column, row, visit);
    }
  }

 private:
  Box grown(std::size_t i) const { return boxes_[i].inflated(reach_m_); }

  // Rounding is monotone: what is not beyond another in a coordinate is in no later cell.
  std::size_t cell(double value, double low, std::size_t cells) const {
    const double at = (value - low) * per_metre_;
    if (!(at > 0.0)) return 0;
    return at < static_cast<double>(cells) ? static_cast<std::size_t>(static_cast<std::int64_t>(at))
                                           : cells - 1;
  }
  std::size_t column_of(double x) const { return cell(x, low_.x, columns_); }
  std::size_t row_of(double y) const { return cell(y, low_.y, rows_); }

  // Two boxes may share many cells: the pair belongs to the one where what they share begins.
  template <class Visit>
  void visit_cell(std::size_t column, std::size_t row, const Visit& visit) const {
    const std::size_t at = row * columns_ + column;
    for (std::uint32_t p = starts_[at]; p + 1 < starts_[at + 1]; ++p) {
      const Box box = grown(entries_[p]);
      for (std::uint32_t q = p + 1; q < starts_[at + 1]; ++q) {
        const Box other = grown(entries_[q]);
        if (!boxes_meet(box, other)) continue;
        const double x = box.min_x > other.min_x ? box.min_x : other.min_x;
        const double y = box.min_y > other.min_y ? box.min_y : other.min_y;
        if (column_of(x) == column && row_of(y) == row) visit(entries_[p], entries_[q]);
      }
    }
  }

  bool choose_cells();
  std::size_t count_entries();
  bool are_few_pairs() const;
  void sort_entries();
  template <class Visit>
  void for_each_cell_of(const Box& box, const Visit& visit) const;

  std::span<const Box> boxes_;
  double reach_m_;
  bool pays_ = false;
  Point low_;
  double per_metre_ = 0.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> starts_;   // per cell, and the end: into entries_
  std::vector<std::uint32_t> entries_;  // boxes, ascending within a cell
};

}  // namespace mapwright
