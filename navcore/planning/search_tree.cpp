#include "navcore/planning/search_tree.hpp"

#include <algorithm>

namespace mapwright::navcore {
namespace {

double offset_from_split(bool split_x, Point split, Point p) {
  return split_x ? p.x - split.x : p.y - split.y;
}

}  // namespace

void SearchTree::Neighbours::offer(Node node, double squared_distance) {
  if (squared_distance >= reach()) return;
  count_ = std::min(count_ + 1, kMostNeighbours);
  std::size_t at = count_ - 1;
  for (; at > 0 && squared_distance < squared_distances_[at - 1]; --at) {
    squared_distances_[at] = squared_distances_[at - 1];
    nodes_[at] = nodes_[at - 1];
  }
  squared_distances_[at] = squared_distance;
  nodes_[at] = node;
}

double SearchTree::Neighbours::reach() const {
  return count_ < kMostNeighbours ? HUGE_VAL : squared_distances_[kMostNeighbours - 1];
}

SearchTree::SearchTree(Point root) {
  nodes_.push_back({root, kNone, {kNone, kNone}});
}

SearchTree::Node SearchTree::add(Point p, Node parent) {
  const auto added = static_cast<Node>(nodes_.size());
  Node node = 0;
  for (bool split_x = true;; split_x = !split_x) {
    const bool behind = offset_from_split(split_x, nodes_[node].point, p) >= 0.0;
    Node& child = nodes_[node].children[behind];
    if (child == kNone) {
      child = added;
      break;
    }
    node = child;
  }
  nodes_.push_back({p, parent, {kNone, kNone}});
  return added;
}

SearchTree::Neighbours SearchTree::nearest(Point p) const {
  Neighbours neighbours;
  visit(0, true, p, neighbours);
  return neighbours;
}

void SearchTree::visit(Node node, bool split_x, Point p, Neighbours& neighbours) const {
  const Entry& entry = nodes_[node];
  neighbours.offer(node, squared_length(entry.point - p));
  const double offset = offset_from_split(split_x, entry.point, p);
  const bool behind = offset >= 0.0;
  if (const Node near = entry.children[behind]; near != kNone) {
    visit(near, !split_x, p, neighbours);
  }
  if (const Node far = entry.children[!behind]; far != kNone) {
    if (offset * offset <= neighbours.reach()) visit(far, !split_x, p, neighbours);
  }
}

std::vector<Point> SearchTree::path_to_root(Node node) const {
  std::vector<Point> path;
  for (; node != kNone; node = nodes_[node].parent) path.push_back(nodes_[node].point);
  return path;
}

void SearchTree::append_edges(std::vector<TreeEdge>& edges) const {
  for (const Entry& entry : nodes_) {
    if (entry.parent != kNone) edges.push_back({nodes_[entry.parent].point, entry.point});
  }
}

}  // namespace mapwright::navcore
