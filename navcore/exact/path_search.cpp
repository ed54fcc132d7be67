#include "navcore/exact/path_search.hpp"

#include <algorithm>

#include "navcore/exact/path_search_run.hpp"

namespace mapwright::navcore::exact {
namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

// Lengths that differ by less are the same length, computed in another order.
constexpr double kSameLength = 1.0 + 1e-12;

}  // namespace

void SearchSpace::begin(const CellMesh& mesh) {
  ++search_;
  effort = {};
  roots_.clear();
  nodes_.clear();
  queue_.clear();
  if (best_.size() != mesh.vertex_count() || goal_search_.size() != mesh.cell_count()) {
    best_.assign(mesh.vertex_count(), {});
    goal_search_.assign(mesh.cell_count(), 0);
    search_ = 1;
  }
}

std::optional<GridPath> PathSearch::run(GridPoint start, std::span<const std::uint32_t> start_cells,
                                        std::span<const std::uint32_t> goal_cells) {
  if (start == goal_) return GridPath{{start}, 0.0};
  mark_goal(goal_cells);
  space_.roots_.push_back({start, kNoVertex, 0, 0.0});
  for (const std::uint32_t cell : start_cells) {
    if (std::find(goal_cells.begin(), goal_cells.end(), cell) != goal_cells.end()) {
      return GridPath{{start, goal_}, distance_mm(start, goal_)};
    }
  }
  space_.successors_.clear();
  for (const std::uint32_t cell : start_cells) start_in(cell);
  for (const Node& node : space_.successors_) enqueue(node);
  return search();
}

// The goal's cells, and the pockets around each of them, may be entered.
void PathSearch::mark_goal(std::span<const std::uint32_t> goal_cells) {
  for (std::uint32_t cell : goal_cells) {
    while (true) {
      space_.goal_search_[cell] = space_.search_;
      const std::uint32_t out = mesh_.way_out(cell);
      if (out == cell) break;
      cell = out;
    }
  }
}

void PathSearch::start_in(std::uint32_t cell) {
  const GridPoint start = space_.roots_[0].point;
  for (std::uint32_t i = mesh_.first_corner(cell); i < mesh_.end_corner(cell); ++i) {
    const GridPoint p = at(i).point, q = after(i).point;
    // The cell across a side on which the start lies is one of the start's own.
    if (!is_on_segment(start, p, q)) look_through(0, i);
  }
}

std::optional<GridPath> PathSearch::search() {
  const auto later = [](const Queued& p, const Queued& q) {
    return p.f_mm != q.f_mm ? p.f_mm > q.f_mm : p.node < q.node;
  };
  auto& queue = space_.queue_;
  while (!queue.empty()) {
    std::pop_heap(queue.begin(), queue.end(), later);
    const Node node = space_.nodes_[queue.back().node];
    queue.pop_back();
    if (node.corner < 0) return path_to(node.root);
    if (!is_outdone(space_.roots_[node.root])) expand(node);
  }
  return std::nullopt;
}

// Follows the node as long as it has a single successor.
void PathSearch::expand(Node node) {
  while (true) {
    ++space_.effort.expanded;
    space_.successors_.clear();
    find_successors(node);
    if (space_.successors_.size() != 1 || space_.successors_[0].corner < 0) break;
    node = space_.successors_[0];
  }
  for (const Node& successor : space_.successors_) enqueue(successor);
}

void PathSearch::finish(std::uint32_t root) {
  const Root& last = space_.roots_[root];
  Node node{};
  node.root = root;
  node.corner = -1;
  node.f_mm = last.g_mm + distance_mm(last.point, goal_);
  space_.successors_.push_back(node);
}

void PathSearch::enqueue(const Node& node) {
  ++space_.effort.pushed;
  space_.queue_.push_back({node.f_mm, static_cast<std::uint32_t>(space_.nodes_.size())});
  space_.nodes_.push_back(node);
  std::push_heap(space_.queue_.begin(), space_.queue_.end(), [](const Queued& p, const Queued& q) {
    return p.f_mm != q.f_mm ? p.f_mm > q.f_mm : p.node < q.node;
  });
}

// A new root at the corner, reached straight from `root`; nothing where no shortest path turns
// there, or a shorter way to it is known.
std::optional<std::uint32_t> PathSearch::turn_at(std::uint32_t root, std::uint32_t corner) {
  const Corner& pivot = at(corner);
  if (!mesh_.can_turn_at(pivot.vertex)) return std::nullopt;
  const Root& before = space_.roots_[root];
  const double g_mm = before.g_mm + distance_mm(before.point, pivot.point);
  auto& best = space_.best_[pivot.vertex];
  if (best.search == space_.search_ && g_mm > best.g_mm * kSameLength) {
    return std::nullopt;
  }
  if (best.search != space_.search_ || g_mm < best.g_mm) best = {space_.search_, g_mm};
  space_.roots_.push_back({pivot.point, pivot.vertex, root, g_mm});
  return static_cast<std::uint32_t>(space_.roots_.size() - 1);
}

bool PathSearch::is_outdone(const Root& root) const {
  if (root.vertex == kNoVertex) return false;
  return root.g_mm > space_.best_[root.vertex].g_mm * kSameLength;
}

GridPath PathSearch::path_to(std::uint32_t root) const {
  GridPath path;
  path.points.push_back(goal_);
  for (std::uint32_t i = root;; i = space_.roots_[i].parent) {
    const GridPoint p = space_.roots_[i].point;
    if (p != path.points.back()) {
      const std::size_t n = path.points.size();
      if (n >= 2 && orient(path.points[n - 2], path.points[n - 1], p) == 0) path.points.pop_back();
      path.points.push_back(p);
    }
    if (i == 0) break;
  }
  std::reverse(path.points.begin(), path.points.end());
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    path.length_mm += distance_mm(path.points[i - 1], path.points[i]);
  }
  return path;
}

std::optional<GridPath> find_shortest_path(const CellMesh& mesh, GridPoint start, GridPoint goal,
                                           std::span<const std::uint32_t> start_cells,
                                           std::span<const std::uint32_t> goal_cells,
                                           SearchSpace& space) {
  if (start_cells.empty() || goal_cells.empty()) return std::nullopt;
  return PathSearch(mesh, goal, space).run(start, start_cells, goal_cells);
}

}  // namespace mapwright::navcore::exact
