#include "navcore/engine/item_bins.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::navcore::engine {
namespace {

constexpr double kItemsPerBin = 4.0;
constexpr double kSmallestBin_m = 0.5;

// Rounding may put a point on a bin's edge into either bin: items reach this far (share of a bin)
// beyond themselves.
constexpr double kSlack = 1e-6;

std::int32_t bin_number(double offset_bins, std::int32_t count) {
  if (!(offset_bins > 0.0)) return 0;
  if (offset_bins >= count) return count - 1;
  return static_cast<std::int32_t>(offset_bins);
}

// Nothing sensible lies further out (metres); what does goes to the outermost bins.
constexpr double kFarthest_m = 1e8;

Box extent_of(std::span<const BinItem> items) {
  const auto near = [](double value) { return std::clamp(value, -kFarthest_m, kFarthest_m); };
  Box extent = kEmptyBox;
  for (const BinItem& item : items) {
    extent.add({near(item.a.x), near(item.a.y)});
    extent.add({near(item.b.x), near(item.b.y)});
  }
  return extent;
}

struct Interval {
  double low, high;
};

Interval ordered(double p, double q) {
  return p < q ? Interval{p, q} : Interval{q, p};
}

// The x that the part of the item within the band low_y … high_y takes.
Interval x_within(const BinItem& item, double low_y, double high_y) {
  if (item.is_area || item.a.y == item.b.y) return ordered(item.a.x, item.b.x);
  const double slope = (item.b.x - item.a.x) / (item.b.y - item.a.y);
  const Interval y = ordered(item.a.y, item.b.y);
  return ordered(item.a.x + slope * (std::clamp(low_y, y.low, y.high) - item.a.y),
                 item.a.x + slope * (std::clamp(high_y, y.low, y.high) - item.a.y));
}

}  // namespace

BinIndex ItemBins::clamped(Point p) const {
  return {bin_number((p.x - corner_.x) / size_m_, columns_),
          bin_number((p.y - corner_.y) / size_m_, rows_)};
}

void ItemBins::lay_out(const Box& extent, std::size_t items) {
  const double wanted_bins = std::max(1.0, static_cast<double>(items) / kItemsPerBin);
  const double longer = std::max(extent.width(), extent.height());
  size_m_ = std::max({kSmallestBin_m, std::sqrt(extent.width() * extent.height() / wanted_bins),
                      longer / (4.0 * wanted_bins), longer / 1e6});
  corner_ = {extent.min_x, extent.min_y};
  columns_ = static_cast<std::int32_t>(extent.width() / size_m_) + 1;
  rows_ = static_cast<std::int32_t>(extent.height() / size_m_) + 1;
}

template <class Visit>
void ItemBins::for_each_bin(const BinItem& item, Visit&& visit) const {
  const double slack = kSlack * size_m_;
  const Interval y = ordered(item.a.y, item.b.y);
  const std::int32_t first_row = clamped({0.0, y.low - slack}).row;
  const std::int32_t last_row = clamped({0.0, y.high + slack}).row;
  for (std::int32_t row = first_row; row <= last_row; ++row) {
    const double low_y = corner_.y + row * size_m_;
    const Interval x = x_within(item, low_y - slack, low_y + size_m_ + slack);
    const std::int32_t last = clamped({x.high + slack, 0.0}).column;
    for (std::int32_t column = clamped({x.low - slack, 0.0}).column; column <= last; ++column) {
      visit(offset({column, row}));
    }
  }
}

ItemBins::ItemBins(std::span<const BinItem> items) {
  if (items.empty()) return;
  lay_out(extent_of(items), items.size());
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const BinItem& item : items) {
    for_each_bin(item, [&](std::size_t bin) { ++starts_[bin]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t& start : starts_) start = total += start;
  items_.resize(total);
  // Filled from the back, so that each start ends where its bin begins and items stay in order.
  for (std::size_t i = items.size(); i-- > 0;) {
    for_each_bin(items[i],
                 [&](std::size_t bin) { items_[--starts_[bin]] = static_cast<std::uint32_t>(i); });
  }
}

}  // namespace mapwright::navcore::engine
