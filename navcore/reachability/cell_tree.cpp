#include "navcore/reachability/cell_tree.hpp"

#include <algorithm>
#include <cassert>

namespace mapwright::navcore {
namespace {

constexpr int kMostLevels = 30;  // coordinates in finest cells fit 32 bits

}  // namespace

CellTree::CellTree(const Box& area, double finest_m) : origin_{area.min_x, area.min_y} {
  const double side_m = std::max(area.width(), area.height());
  const double levels = std::ceil(std::log2(std::max(1.0, side_m / finest_m)));
  depth_ = std::min(kMostLevels, static_cast<int>(levels));
  finest_m_ = side_m / std::ldexp(1.0, depth_);
  nodes_.push_back({});
}

Point CellTree::center(Cell cell) const {
  const Node& node = nodes_[cell];
  const double half = 0.5 * width(cell);
  return {origin_.x + finest_m_ * (node.x + half), origin_.y + finest_m_ * (node.y + half)};
}

Box CellTree::box(Cell cell) const {
  const Node& node = nodes_[cell];
  const double x = origin_.x + finest_m_ * node.x;
  const double y = origin_.y + finest_m_ * node.y;
  return {x, y, x + side_m(cell), y + side_m(cell)};
}

CellTree::Cell CellTree::split(Cell cell) {
  assert(is_leaf(cell) && !is_finest(cell));
  const auto first = static_cast<Cell>(nodes_.size());
  const Node parent = nodes_[cell];
  const std::uint32_t half = width(cell) / 2;
  const auto level = static_cast<std::uint8_t>(parent.level + 1);
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    nodes_.push_back({parent.x + (quarter & 1U) * half, parent.y + (quarter >> 1U) * half, kNone,
                      level, Passage::kUndecided});
  }
  nodes_[cell].first_child = first;
  return first;
}

CellTree::Cell CellTree::descend(std::uint32_t x, std::uint32_t y, int deepest_level) const {
  Cell cell = 0;
  while (!is_leaf(cell) && nodes_[cell].level < deepest_level) {
    const int shift = depth_ - nodes_[cell].level - 1;
    cell = nodes_[cell].first_child + ((x >> shift) & 1U) + 2 * ((y >> shift) & 1U);
  }
  return cell;
}

CellTree::Cell CellTree::leaf_at(Point p) const {
  const double cells = std::ldexp(1.0, depth_);
  const double x = (p.x - origin_.x) / finest_m_;
  const double y = (p.y - origin_.y) / finest_m_;
  if (!(x >= 0.0 && y >= 0.0 && x <= cells && y <= cells)) return kNone;
  return descend(static_cast<std::uint32_t>(std::min(x, cells - 1.0)),
                 static_cast<std::uint32_t>(std::min(y, cells - 1.0)), depth_);
}

CellTree::Cell CellTree::node_beside(Cell cell, int side) const {
  static constexpr std::array<std::int64_t, 4> kDx{-1, 1, 0, 0};
  static constexpr std::array<std::int64_t, 4> kDy{0, 0, -1, 1};
  const Node& node = nodes_[cell];
  const std::int64_t step = width(cell);
  const std::int64_t x = node.x + step * kDx[static_cast<std::size_t>(side)];
  const std::int64_t y = node.y + step * kDy[static_cast<std::size_t>(side)];
  const std::int64_t cells = std::int64_t{1} << depth_;
  if (x < 0 || y < 0 || x >= cells || y >= cells) return kNone;
  return descend(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), node.level);
}

}  // namespace mapwright::navcore
