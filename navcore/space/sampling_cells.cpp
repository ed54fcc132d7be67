#include "navcore/space/sampling_cells.hpp"

#include <algorithm>
#include <array>

namespace mapwright::navcore {
namespace {

constexpr std::size_t kMostCells = 40000;
constexpr int kMostSplits = 24;

double area_m2(const Box& box) {
  return box.width() * box.height();
}

std::array<Box, 4> quarters(const Box& box) {
  const double x = 0.5 * (box.min_x + box.max_x);
  const double y = 0.5 * (box.min_y + box.max_y);
  return {Box{box.min_x, box.min_y, x, y}, Box{x, box.min_y, box.max_x, y},
          Box{box.min_x, y, x, box.max_y}, Box{x, y, box.max_x, box.max_y}};
}

}  // namespace

SamplingCells::SamplingCells(const Box& box, const std::function<CellState(const Box&)>& classify) {
  if (!(area_m2(box) > 0.0)) return;
  cells_.push_back({box, false});
  for (int i = 0; i < kMostSplits && cells_.size() < kMostCells && !is_good_enough(); ++i) {
    split_mixed(classify);
  }
  double total = 0.0;
  for (const Cell& cell : cells_) cumulated_area_m2_.push_back(total += area_m2(cell.box));
}

bool SamplingCells::is_good_enough() const {
  double free = 0.0;
  double total = 0.0;
  for (const Cell& cell : cells_) {
    total += area_m2(cell.box);
    if (cell.free) free += area_m2(cell.box);
  }
  return free >= 0.5 * total;
}

void SamplingCells::split_mixed(const std::function<CellState(const Box&)>& classify) {
  std::vector<Cell> finer;
  for (const Cell& cell : cells_) {
    if (cell.free) {
      finer.push_back(cell);
      continue;
    }
    for (const Box& part : quarters(cell.box)) {
      const CellState state = classify(part);
      if (state != CellState::kSolid) finer.push_back({part, state == CellState::kFree});
    }
  }
  cells_ = std::move(finer);
}

std::optional<Point> SamplingCells::draw(Random& random) const {
  if (cells_.empty()) return std::nullopt;
  const double place = random.uniform(0.0, cumulated_area_m2_.back());
  const auto found = std::upper_bound(cumulated_area_m2_.begin(), cumulated_area_m2_.end(), place);
  const auto i =
      std::min(static_cast<std::size_t>(found - cumulated_area_m2_.begin()), cells_.size() - 1);
  const Box& box = cells_[i].box;
  const double x = random.uniform(box.min_x, box.max_x);
  return Point{x, random.uniform(box.min_y, box.max_y)};
}

}  // namespace mapwright::navcore
