// Private to this folder: a tree of points that grows and finds its nearest nodes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "navcore/planning/planner.hpp"

namespace mapwright::navcore {

/// Nodes with parents, found by place through a k-d tree over the same nodes. Points that come in
/// random order keep it balanced without further work: adding and finding take log n.
class SearchTree {
 public:
  using Node = std::uint32_t;
  static constexpr std::size_t kMostNeighbours = 16;

  explicit SearchTree(Point root);

  Node add(Point p, Node parent);
  std::size_t size() const { return nodes_.size(); }
  Point point(Node node) const { return nodes_[node].point; }

  /// The up to `kMostNeighbours` nodes nearest to a point, nearest first; of equally near ones the
  /// older first.
  class Neighbours {
   public:
    const Node* begin() const { return nodes_.data(); }
    const Node* end() const { return nodes_.data() + count_; }

   private:
    friend class SearchTree;
    void offer(Node node, double squared_distance);
    double reach() const;

    std::array<Node, kMostNeighbours> nodes_{};
    std::array<double, kMostNeighbours> squared_distances_{};
    std::size_t count_ = 0;
  };
  Neighbours nearest(Point p) const;

  /// From the node to the root, both included.
  std::vector<Point> path_to_root(Node node) const;

  void append_edges(std::vector<TreeEdge>& edges) const;

 private:
  static constexpr Node kNone = UINT32_MAX;
  struct Entry {
    Point point;
    Node parent = kNone;
    std::array<Node, 2> children{kNone, kNone};  // of the k-d tree: before and behind the split
  };

  void visit(Node node, bool split_x, Point p, Neighbours& neighbours) const;

  std::vector<Entry> nodes_;
};

}  // namespace mapwright::navcore
