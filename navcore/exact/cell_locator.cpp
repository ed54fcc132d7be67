#include "navcore/exact/cell_locator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mapwright::navcore::exact {

CellLocator::CellLocator(const CellMesh& mesh) : mesh_(mesh) {
  choose_size();
  first_.assign(columns_ * rows_ + 1, 0);
  for (std::uint32_t cell = 0; cell < mesh.cell_count(); ++cell) {
    for_each_bucket(cell, [&](std::size_t bucket) { ++first_[bucket + 1]; });
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cells_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t cell = 0; cell < mesh.cell_count(); ++cell) {
    for_each_bucket(cell, [&](std::size_t bucket) { cells_[next[bucket]++] = cell; });
  }
}

std::vector<std::uint32_t> CellLocator::cells_at(GridPoint p) const {
  std::vector<std::uint32_t> found;
  if (p.x < min_x_ || p.x > max_x_ || p.y < min_y_ || p.y > max_y_) return found;
  const std::size_t bucket = row(p.y) * columns_ + column(p.x);
  for (std::size_t i = first_[bucket]; i < first_[bucket + 1]; ++i) {
    if (mesh_.contains(cells_[i], p)) found.push_back(cells_[i]);
  }
  return found;
}

// As many square buckets as there are cells.
void CellLocator::choose_size() {
  if (mesh_.cell_count() == 0) return;
  Box box = kEmptyBox;
  for (const Corner& corner : mesh_.corners()) {
    box.add({static_cast<double>(corner.point.x), static_cast<double>(corner.point.y)});
  }
  min_x_ = box.min_x, min_y_ = box.min_y, max_x_ = box.max_x, max_y_ = box.max_y;
  const double area = (box.width() + 1.0) * (box.height() + 1.0);
  bucket_mm_ = std::max({std::sqrt(area / static_cast<double>(mesh_.cell_count())),
                         std::max(box.width(), box.height()) / 16384.0, 1.0});
  columns_ = static_cast<std::size_t>(box.width() / bucket_mm_) + 1;
  rows_ = static_cast<std::size_t>(box.height() / bucket_mm_) + 1;
}

std::size_t CellLocator::row(double y) const {
  return static_cast<std::size_t>(
      std::clamp((y - min_y_) / bucket_mm_, 0.0, static_cast<double>(rows_ - 1)));
}

std::size_t CellLocator::column(double x) const {
  return static_cast<std::size_t>(
      std::clamp((x - min_x_) / bucket_mm_, 0.0, static_cast<double>(columns_ - 1)));
}

// Widens `reach` by the columns that the side ab, a little enlarged, has in the row.
void CellLocator::widen(Reach& reach, GridPoint a, GridPoint b, std::size_t row) const {
  if (a.y > b.y) std::swap(a, b);
  constexpr double kSlack_mm = 1.0;
  const double bottom = min_y_ + static_cast<double>(row) * bucket_mm_ - kSlack_mm;
  const double top = bottom + bucket_mm_ + 2.0 * kSlack_mm;
  if (b.y < bottom || a.y > top) return;
  const double rise = static_cast<double>(std::int64_t{b.y} - a.y);
  const double run = static_cast<double>(std::int64_t{b.x} - a.x);
  const double from = rise > 0.0 ? std::clamp((bottom - a.y) / rise, 0.0, 1.0) : 0.0;
  const double to = rise > 0.0 ? std::clamp((top - a.y) / rise, 0.0, 1.0) : 1.0;
  const double x1 = a.x + from * run, x2 = a.x + to * run;
  reach.first_column = std::min(reach.first_column, column(std::min(x1, x2) - kSlack_mm));
  reach.last_column = std::max(reach.last_column, column(std::max(x1, x2) + kSlack_mm));
}

template <class Visit>
void CellLocator::for_each_bucket(std::uint32_t cell, Visit visit) const {
  const auto corners = mesh_.corners().subspan(mesh_.first_corner(cell),
                                               mesh_.end_corner(cell) - mesh_.first_corner(cell));
  const auto [low, high] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const Corner& p, const Corner& q) { return p.point.y < q.point.y; });
  const std::size_t last_row = row(high->point.y);
  for (std::size_t r = row(low->point.y); r <= last_row; ++r) {
    Reach reach{columns_, 0};
    GridPoint from = corners.back().point;
    for (const Corner& corner : corners) {
      widen(reach, from, corner.point, r);
      from = corner.point;
    }
    for (std::size_t c = reach.first_column; c <= reach.last_column && c < columns_; ++c) {
      visit(r * columns_ + c);
    }
  }
}

}  // namespace mapwright::navcore::exact
