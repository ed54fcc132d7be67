#include "navcore/exact/line_grid.hpp"

#include <limits>

namespace mapwright::navcore::exact {

LineGrid::LineGrid(const std::vector<Line>& lines) {
  choose_size(lines);
  first_.assign(columns_ * rows_ + 1, 0);
  for (const Line& line : lines) {
    for_each_bucket(line.a, line.b, [&](std::size_t bucket) { ++first_[bucket + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  lines_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    for_each_bucket(lines[i].a, lines[i].b,
                    [&](std::size_t bucket) { lines_[next[bucket]++] = i; });
  }
}

// Square buckets: as many as there are lines, or fewer where the lines are so long that they would
// pass through many.
void LineGrid::choose_size(const std::vector<Line>& lines) {
  if (lines.empty()) return;
  std::int64_t max_x = std::numeric_limits<std::int64_t>::min(), max_y = max_x;
  min_x_ = min_y_ = std::numeric_limits<std::int64_t>::max();
  double total_mm = 0.0;
  for (const Line& line : lines) {
    min_x_ = std::min<std::int64_t>({min_x_, line.a.x, line.b.x});
    min_y_ = std::min<std::int64_t>({min_y_, line.a.y, line.b.y});
    max_x = std::max<std::int64_t>({max_x, line.a.x, line.b.x});
    max_y = std::max<std::int64_t>({max_y, line.a.y, line.b.y});
    total_mm += distance_mm(line.a, line.b);
  }
  const auto count = static_cast<double>(lines.size());
  const double width = static_cast<double>(max_x - min_x_) + 1.0;
  const double height = static_cast<double>(max_y - min_y_) + 1.0;
  bucket_mm_ = std::max({std::sqrt(width * height / count), total_mm / count / 4.0,
                         std::max(width, height) / 16384.0, 1.0});
  buckets_per_mm_ = 1.0 / bucket_mm_;
  columns_ = static_cast<std::size_t>(width / bucket_mm_) + 1;
  rows_ = static_cast<std::size_t>(height / bucket_mm_) + 1;
}

// Columns that the segment low-high (low.y <= high.y), widened by a millimetre, reaches in a row.
std::pair<std::size_t, std::size_t> LineGrid::reach_in_row(GridPoint low, GridPoint high,
                                                           std::size_t row) const {
  const double row_bottom = static_cast<double>(row) * bucket_mm_ + static_cast<double>(min_y_);
  const double rise = static_cast<double>(std::int64_t{high.y} - low.y);
  const double run = static_cast<double>(std::int64_t{high.x} - low.x);
  double from_x = low.x, to_x = high.x;
  if (rise > 0.0) {
    const double slack = 2.0 / rise;
    const double from = std::clamp((row_bottom - low.y) / rise - slack, 0.0, 1.0);
    const double to = std::clamp((row_bottom + bucket_mm_ - low.y) / rise + slack, 0.0, 1.0);
    from_x = low.x + from * run;
    to_x = low.x + to * run;
  }
  if (from_x > to_x) std::swap(from_x, to_x);
  return {column(static_cast<std::int64_t>(std::floor(from_x)) - 2),
          column(static_cast<std::int64_t>(std::ceil(to_x)) + 2)};
}

}  // namespace mapwright::navcore::exact
