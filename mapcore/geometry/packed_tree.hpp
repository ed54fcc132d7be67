// Private to this folder: A packed R-tree: boxes found by place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

constexpr bool boxes_meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

constexpr Box box_of(Point a, Point b) {
  return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.x < b.x ? b.x : a.x,
          a.y < b.y ? b.y : a.y};
}

/// Positions of `boxes` along a Hilbert curve through their centres (Kamel and Faloutsos, On
/// Packing R-trees, 1993).
std::vector<std::uint32_t> hilbert_order(std::size_t count, const Box& extent,
                                         std::span<const Point> centers);

/// An R-tree over items 0 … n − 1, packed along a Hilbert curve: no slack, no insertion, boxes kept
/// for the inner nodes only.
class PackedTree {
 public:
  static constexpr std::size_t kFanout = 8;

  /// `item_box(i)` is the box of item i.
  template <class ItemBox>
  PackedTree(std::size_t count, const ItemBox& item_box) : order_(sorted(count, item_box)) {
    if (count == 0) return;
    levels_.push_back(grouped(order_.size(), [&](std::size_t k) { return item_box(order_[k]); }));
    while (levels_.back().size() > 1) {
      const auto& below = levels_.back();
      levels_.push_back(grouped(below.size(), [&](std::size_t k) { return below[k]; }));
    }
  }

  /// Visits the items under all nodes for whose box `enter(box)` holds; stops, and returns false,
  /// when `visit(item)` returns false.
  template <class Enter, class Visit>
  bool walk(const Enter& enter, const Visit& visit) const {
    if (levels_.empty()) return true;
    return walk_node(levels_.size() - 1, 0, enter, visit);
  }

  /// Visits items by growing distance of the nodes that hold them, nodes nearer than the bound
  /// only: `distance(box)` is a lower bound for the items within, `visit(item)` may lower `bound`.
  template <class Distance, class Visit>
  void approach(const Distance& distance, const double& bound, const Visit& visit) const {
    if (!levels_.empty()) approach_node(levels_.size() - 1, 0, distance, bound, visit);
  }

 private:
  template <class ItemBox>
  static std::vector<std::uint32_t> sorted(std::size_t count, const ItemBox& item_box) {
    std::vector<Point> centers(count);
    Box extent = kEmptyBox;
    for (std::size_t i = 0; i < count; ++i) {
      const Box box = item_box(i);
      centers[i] = {0.5 * box.min_x + 0.5 * box.max_x, 0.5 * box.min_y + 0.5 * box.max_y};
      extent.add(centers[i]);
    }
    return hilbert_order(count, extent, centers);
  }

  template <class ChildBox>
  static std::vector<Box> grouped(std::size_t children, const ChildBox& child_box) {
    std::vector<Box> boxes((children + kFanout - 1) / kFanout, kEmptyBox);
    for (std::size_t k = 0; k < children; ++k) {
      const Box child = child_box(k);
      boxes[k / kFanout].add({child.min_x, child.min_y});
      boxes[k / kFanout].add({child.max_x, child.max_y});
    }
    return boxes;
  }

  // Children of a node: items on level 0, nodes of the level below elsewhere.
  static std::size_t first_child(std::size_t node) { return node * kFanout; }
  std::size_t end_child(std::size_t level, std::size_t node) const {
    const std::size_t all = level == 0 ? order_.size() : levels_[level - 1].size();
    return std::min(all, (node + 1) * kFanout);
  }

  template <class Enter, class Visit>
  bool walk_node(std::size_t level, std::size_t node, const Enter& enter,
                 const Visit& visit) const {
    if (!enter(levels_[level][node])) return true;
    const std::size_t end = end_child(level, node);
    for (std::size_t child = first_child(node); child < end; ++child) {
      const bool goes_on =
          level == 0 ? visit(order_[child]) : walk_node(level - 1, child, enter, visit);
      if (!goes_on) return false;
    }
    return true;
  }

  template <class Distance, class Visit>
  void approach_node(std::size_t level, std::size_t node, const Distance& distance,
                     const double& bound, const Visit& visit) const {
    const std::size_t first = first_child(node), end = end_child(level, node);
    if (level == 0) {
      for (std::size_t child = first; child < end; ++child) visit(order_[child]);
      return;
    }
    struct Child {
      double distance;
      std::size_t node;
    };
    std::array<Child, kFanout> children;
    std::size_t count = 0;
    for (std::size_t child = first; child < end; ++child) {
      const Child entry{distance(levels_[level - 1][child]), child};
      std::size_t at = count++;
      for (; at > 0 && entry.distance < children[at - 1].distance; --at) {
        children[at] = children[at - 1];
      }
      children[at] = entry;
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (children[k].distance > bound) return;
      approach_node(level - 1, children[k].node, distance, bound, visit);
    }
  }

  std::vector<std::uint32_t> order_;      // items in the order of the leaves
  std::vector<std::vector<Box>> levels_;  // from the nodes above the items up to the root
};

}  // namespace mapwright
