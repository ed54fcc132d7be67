#include "mapcore/geometry/box_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mapwright {
namespace {

// A box meets so many cells on average, at most.
constexpr std::size_t kMostCellsPerBox = 16;

// As many pairs of boxes share a cell, at most.
constexpr std::size_t kMostPairsPerBox = 64;

}  // namespace

BoxGrid::BoxGrid(std::span<const Box> boxes, double reach_m) : boxes_(boxes), reach_m_(reach_m) {
  pays_ = boxes_.size() < UINT32_MAX / kMostCellsPerBox && choose_cells() &&
          count_entries() <= kMostCellsPerBox * boxes_.size() && are_few_pairs();
  if (pays_) {
    sort_entries();
  } else {
    rows_ = columns_ = 0;
    starts_.clear();
  }
}

// About as many cells as boxes, none smaller than boxes are on average.
bool BoxGrid::choose_cells() {
  Box all = kEmptyBox;
  double sides_m = 0.0;
  std::size_t count = 0;
  for (const Box& box : boxes_) {
    if (box.is_empty()) continue;
    all.add({box.min_x, box.min_y});
    all.add({box.max_x, box.max_y});
    sides_m += 0.5 * (box.width() + box.height()) + 2.0 * reach_m_;
    ++count;
  }
  if (count == 0) return true;
  all = all.inflated(reach_m_);
  const auto n = static_cast<double>(count);
  const double side_m = std::max({std::sqrt(all.width()) * std::sqrt(all.height()) / std::sqrt(n),
                                  sides_m / n, std::max(all.width(), all.height()) / n, 1e-3});
  low_ = {all.min_x, all.min_y};
  per_metre_ = 1.0 / side_m;
  const double columns = all.width() * per_metre_ + 1.0, rows = all.height() * per_metre_ + 1.0;
  if (!(columns * rows <= 8.0 * n + 16.0)) return false;
  columns_ = static_cast<std::size_t>(columns);
  rows_ = static_cast<std::size_t>(rows);
  return true;
}

template <class Visit>
void BoxGrid::for_each_cell_of(const Box& box, const Visit& visit) const {
  const std::size_t right = column_of(box.max_x), top = row_of(box.max_y);
  const std::size_t left = column_of(box.min_x);
  for (std::size_t row = row_of(box.min_y); row <= top; ++row) {
    for (std::size_t column = left; column <= right; ++column) visit(row * columns_ + column);
  }
}

std::size_t BoxGrid::count_entries() {
  const std::size_t most = kMostCellsPerBox * boxes_.size();
  starts_.assign(columns_ * rows_ + 1, 0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes_.size() && count <= most; ++i) {
    if (boxes_[i].is_empty()) continue;
    for_each_cell_of(grown(i), [&](std::size_t at) {
      ++starts_[at];
      ++count;
    });
  }
  return count;
}

// Of boxes in one cell.
bool BoxGrid::are_few_pairs() const {
  std::uint64_t pairs = 0;
  for (const std::uint64_t in_cell : starts_) pairs += in_cell * in_cell / 2;
  return pairs <= kMostPairsPerBox * boxes_.size();
}

// From the counts to the ends of the cells' entries, and from the last box to the first: each goes
// in front of those that are there.
void BoxGrid::sort_entries() {
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  entries_.resize(starts_.back());
  for (std::size_t i = boxes_.size(); i-- > 0;) {
    if (boxes_[i].is_empty()) continue;
    for_each_cell_of(
        grown(i), [&](std::size_t at) { entries_[--starts_[at]] = static_cast<std::uint32_t>(i); });
  }
}

}  // namespace mapwright
