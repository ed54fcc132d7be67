// A quadtree of cells that are proved free, proved blocked, or not yet decided.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::navcore {

/// What is proved of all points of a closed cell as places for the robot's centre.
enum class Passage : std::uint8_t { kUndecided, kFree, kBlocked };

/// Squares within squares. Cells are numbered as they are made; a split cell stays as inner node.
class CellTree {
 public:
  using Cell = std::uint32_t;
  static constexpr Cell kNone = UINT32_MAX;

  /// One undecided cell that covers `area`, and the finest cells at most `finest_m` wide.
  CellTree(const Box& area, double finest_m);

  std::size_t size() const { return nodes_.size(); }
  bool is_leaf(Cell cell) const { return nodes_[cell].first_child == kNone; }
  bool is_finest(Cell cell) const { return nodes_[cell].level == depth_; }
  Passage passage(Cell cell) const { return nodes_[cell].passage; }
  void set_passage(Cell cell, Passage passage) { nodes_[cell].passage = passage; }

  double side_m(Cell cell) const { return finest_m_ * width(cell); }
  double area_m2(Cell cell) const { return side_m(cell) * side_m(cell); }
  Point center(Cell cell) const;
  Box box(Cell cell) const;

  /// Splits a leaf that is not of the finest into four undecided leaves: the returned one and the
  /// three that follow it.
  Cell split(Cell cell);

  /// The leaf that holds a point; kNone outside of the area.
  Cell leaf_at(Point p) const;

  /// Calls `visit(leaf)` for the leaves that share a piece of side with a leaf.
  template <class Visit>
  void for_each_neighbour(Cell cell, Visit visit) const {
    for (int side = 0; side < 4; ++side) {
      const Cell beside = node_beside(cell, side);
      if (beside != kNone) visit_along(beside, side, visit);
    }
  }

  /// The same for neighbours that are not smaller than the leaf: each pair once or twice, if all
  /// leaves are asked.
  template <class Visit>
  void for_each_larger_neighbour(Cell cell, Visit visit) const {
    for (int side = 0; side < 4; ++side) {
      const Cell beside = node_beside(cell, side);
      if (beside != kNone && is_leaf(beside)) visit(beside);
    }
  }

 private:
  struct Node {
    std::uint32_t x = 0, y = 0;  // lower left corner, in finest cells
    Cell first_child = kNone;
    std::uint8_t level = 0;
    Passage passage = Passage::kUndecided;
  };

  std::uint32_t width(Cell cell) const { return std::uint32_t{1} << (depth_ - nodes_[cell].level); }
  Cell descend(std::uint32_t x, std::uint32_t y, int deepest_level) const;
  // The node of the cell's size across a side (0 left, 1 right, 2 below, 3 above), or the larger
  // leaf there.
  Cell node_beside(Cell cell, int side) const;

  // Children of a node that touch the cell from which it lies across `side`: quarters are numbered
  // 0 lower left, 1 lower right, 2 upper left, 3 upper right.
  template <class Visit>
  void visit_along(Cell node, int side, Visit& visit) const {
    if (is_leaf(node)) {
      visit(node);
      return;
    }
    static constexpr std::array<std::array<Cell, 2>, 4> kTouching{{{1, 3}, {0, 2}, {2, 3}, {0, 1}}};
    for (const Cell child : kTouching[static_cast<std::size_t>(side)]) {
      visit_along(nodes_[node].first_child + child, side, visit);
    }
  }

  Point origin_;
  double finest_m_ = 1.0;
  int depth_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace mapwright::navcore
