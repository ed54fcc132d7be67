// Private to this folder: A uniform grid of buckets over lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "navcore/exact/line_work.hpp"

namespace mapwright::navcore::exact {

/// Buckets of the plane that say which lines pass through them. About as many buckets as lines.
class LineGrid {
 public:
  explicit LineGrid(const std::vector<Line>& lines);

  std::size_t bucket_count() const { return first_.size() - 1; }

  /// Lines that pass through the bucket, perhaps some that only come near; ascending.
  std::span<const std::uint32_t> lines_in(std::size_t bucket) const {
    return {lines_.data() + first_[bucket], first_[bucket + 1] - first_[bucket]};
  }

  /// Bucket of a point within the lines' box.
  std::size_t bucket_of(GridPoint p) const { return row(p.y) * columns_ + column(p.x); }

  /// Calls `visit(bucket)` for all buckets that the segment ab, widened by a millimetre to each
  /// side, passes through.
  template <class Visit>
  void for_each_bucket(GridPoint a, GridPoint b, Visit visit) const {
    if (a.y > b.y) std::swap(a, b);
    const std::size_t last_row = row(std::int64_t{b.y} + 1);
    for (std::size_t r = row(std::int64_t{a.y} - 1); r <= last_row; ++r) {
      const auto [left, right] = reach_in_row(a, b, r);
      for (std::size_t c = left; c <= right; ++c) visit(r * columns_ + c);
    }
  }

 private:
  std::size_t column(std::int64_t x) const { return clamped(x - min_x_, columns_); }
  std::size_t row(std::int64_t y) const { return clamped(y - min_y_, rows_); }
  std::size_t clamped(std::int64_t offset, std::size_t count) const {
    const auto index = static_cast<std::int64_t>(static_cast<double>(offset) * buckets_per_mm_);
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(index, 0, static_cast<std::int64_t>(count) - 1));
  }
  void choose_size(const std::vector<Line>& lines);
  std::pair<std::size_t, std::size_t> reach_in_row(GridPoint low, GridPoint high,
                                                   std::size_t row) const;

  std::int64_t min_x_ = 0, min_y_ = 0;
  double bucket_mm_ = 1.0, buckets_per_mm_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> lines_;
};

}  // namespace mapwright::navcore::exact
