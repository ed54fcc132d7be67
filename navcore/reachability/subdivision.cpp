#include "navcore/reachability/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "mapcore/tolerances.hpp"

namespace mapwright::navcore {
namespace {

Box common_part(const Box& p, const Box& q) {
  return {std::max(p.min_x, q.min_x), std::max(p.min_y, q.min_y), std::min(p.max_x, q.max_x),
          std::min(p.max_y, q.max_y)};
}

double depth_within_m(const Box& box, Point p) {
  return std::min({p.x - box.min_x, box.max_x - p.x, p.y - box.min_y, box.max_y - p.y});
}

}  // namespace

Passage prove_passage(const FreeSpace& space, const Box& cell, double radius_m) {
  const Box border = space.border().box();
  const Box inside = common_part(cell, border);
  if (!(inside.width() > 0.0 && inside.height() > 0.0)) return Passage::kBlocked;
  const Point center{0.5 * (inside.min_x + inside.max_x), 0.5 * (inside.min_y + inside.max_y)};
  const double reach_m =
      0.5 * std::hypot(inside.width(), inside.height()) + tolerance::kArithmetic_m;
  const double to_obstacle_m = space.index().clearance_m(center, radius_m + reach_m);
  const double clearance_m = std::min(to_obstacle_m, depth_within_m(border, center));
  if (clearance_m < radius_m - reach_m) return Passage::kBlocked;
  if (clearance_m >= radius_m + reach_m && space.is_free(center)) return Passage::kFree;
  // From a place that is solid to one that is free the way crosses an outline: what is free within
  // reach of a solid place lies nearer than `reach_m` to that outline.
  const bool all_solid_or_near = reach_m < radius_m || to_obstacle_m >= reach_m;
  return all_solid_or_near && !space.is_free(center) ? Passage::kBlocked : Passage::kUndecided;
}

void Subdivision::prove(Cell cell) {
  tree_.set_passage(cell, prove_passage(space_, tree_.box(cell), radius_m_));
}

void Subdivision::split_to(double resolution_m) {
  prove(0);
  for (Cell cell = 0; cell < tree_.size() && tree_.size() + 4 <= max_cells_; ++cell) {
    if (!is_undecided(cell) || tree_.is_finest(cell) || tree_.side_m(cell) <= resolution_m)
      continue;
    const Cell first = tree_.split(cell);
    for (Cell child = first; child < first + 4; ++child) prove(child);
  }
}

// Areas that may be connected: through which undecided cells, and where those begin to belong to
// the one or to the other.
//
// Cells of the finest kind cannot be split, so areas that touch the same chain of them are assumed
// to be connected: nothing better will be known.
struct Subdivision::Doubts {
  Doubts(const Subdivision& subdivision, const CellTree& tree, const UnionFind& sure,
         const std::vector<Cell>& undecided)
      : subdivision_(subdivision),
        tree_(tree),
        sure_(sure),
        possible_(tree.size()),
        assumed_(tree.size()),
        label_(tree.size(), CellTree::kNone),
        doubtful_(tree.size(), false),
        enqueued_(tree.size(), false) {
    join(undecided);
    find_doubtful_groups();
    for (const Cell cell : undecided) {
      if (is_doubtful(cell)) cells_.push_back(cell);
    }
    spread_labels();
  }

  // Undecided cells of groups whose connections are in doubt.
  const std::vector<Cell>& cells() const { return cells_; }

  // Those that can be split and lie beside a cell that is nearer to another area.
  std::vector<Cell> frontier() const {
    std::vector<Cell> frontier;
    for (const Cell cell : cells_) {
      if (tree_.is_finest(cell)) continue;
      bool between = false;
      tree_.for_each_neighbour(cell, [&](Cell beside) {
        between |= !is_blocked(beside) && label(beside) != label_[cell];
      });
      if (between) frontier.push_back(cell);
    }
    return frontier;
  }

 private:
  bool is_blocked(Cell cell) const { return tree_.passage(cell) == Passage::kBlocked; }

  // Free cells stand for all that they are connected with.
  Cell representative(Cell cell) const {
    return subdivision_.is_free(cell) ? sure_.find(cell) : cell;
  }

  bool cannot_be_split(Cell cell) const {
    return subdivision_.is_free(cell) || tree_.is_finest(cell);
  }

  void join(const std::vector<Cell>& undecided) {
    for (const Cell cell : undecided) {
      tree_.for_each_neighbour(cell, [&](Cell beside) {
        if (is_blocked(beside)) return;
        const Cell other = representative(beside);
        possible_.unite(cell, other);
        if (tree_.is_finest(cell) && cannot_be_split(beside)) assumed_.unite(cell, other);
        if (subdivision_.is_free(beside)) areas_.push_back(other);
      });
    }
    std::sort(areas_.begin(), areas_.end());
    areas_.erase(std::unique(areas_.begin(), areas_.end()), areas_.end());
  }

  void find_doubtful_groups() {
    std::vector<Cell> first_area(tree_.size(), CellTree::kNone);
    for (const Cell area : areas_) {
      const Cell assumed = assumed_.find(area);
      label_[assumed] = assumed;
      Cell& first = first_area[possible_.find(area)];
      if (first == CellTree::kNone) first = assumed;
      if (first != assumed) doubtful_[possible_.find(area)] = true;
    }
  }

  bool is_doubtful(Cell cell) const { return doubtful_[possible_.find(cell)]; }

  // Cells that cannot be split share the label of those they are assumed to be connected with.
  Cell label(Cell cell) const {
    return label_[cannot_be_split(cell) ? assumed_.find(representative(cell)) : cell];
  }

  // Breadth first from all areas at once.
  void spread_labels() {
    for (const Cell cell : cells_) {
      if (!tree_.is_finest(cell) || label(cell) == CellTree::kNone) continue;
      queue_.push_back(cell);
    }
    for (const Cell cell : cells_) {
      tree_.for_each_neighbour(cell, [&](Cell beside) {
        if (subdivision_.is_free(beside)) claim(cell, label(beside));
      });
    }
    for (; !queue_.empty(); queue_.pop_front()) {
      const Cell cell = queue_.front();
      tree_.for_each_neighbour(cell, [&](Cell beside) {
        if (!is_blocked(beside) && !subdivision_.is_free(beside)) claim(beside, label(cell));
      });
    }
  }

  void claim(Cell cell, Cell new_label) {
    if (label(cell) != CellTree::kNone) return;
    if (!tree_.is_finest(cell)) {
      label_[cell] = new_label;
      queue_.push_back(cell);
      return;
    }
    label_[assumed_.find(cell)] = new_label;
    enqueue_chain(cell);
  }

  // All finest cells that hang together with this one.
  void enqueue_chain(Cell cell) {
    std::vector<Cell> stack{cell};
    while (!stack.empty()) {
      const Cell next = stack.back();
      stack.pop_back();
      if (enqueued_[next]) continue;
      enqueued_[next] = true;
      queue_.push_back(next);
      tree_.for_each_neighbour(next, [&](Cell beside) {
        const bool same_chain = !is_blocked(beside) && !subdivision_.is_free(beside) &&
                                tree_.is_finest(beside) && !enqueued_[beside];
        if (same_chain) stack.push_back(beside);
      });
    }
  }

  const Subdivision& subdivision_;
  const CellTree& tree_;
  const UnionFind& sure_;
  UnionFind possible_;
  UnionFind assumed_;
  std::vector<Cell> areas_;
  std::vector<Cell> label_;
  std::vector<bool> doubtful_;
  std::vector<bool> enqueued_;
  std::vector<Cell> cells_;
  std::deque<Cell> queue_;
};

std::vector<CellTree::Cell> Subdivision::undecided_cells() const {
  std::vector<Cell> cells;
  for (Cell cell = 0; cell < tree_.size(); ++cell) {
    if (is_undecided(cell)) cells.push_back(cell);
  }
  return cells;
}

std::vector<CellTree::Cell> Subdivision::split_all(const std::vector<Cell>& cells,
                                                   UnionFind& sure) {
  std::vector<Cell> children;
  for (const Cell cell : cells) {
    const Cell first = tree_.split(cell);
    for (Cell child = first; child < first + 4; ++child) {
      prove(child);
      children.push_back(child);
    }
  }
  sure.resize(tree_.size());
  for (const Cell child : children) {
    if (!is_free(child)) continue;
    tree_.for_each_neighbour(child, [&](Cell beside) {
      if (is_free(beside)) sure.unite(child, beside);
    });
  }
  return children;
}

void Subdivision::decide_connections(UnionFind& sure) {
  std::vector<Cell> undecided = undecided_cells();
  while (true) {
    const Doubts doubts(*this, tree_, sure, undecided);
    const std::vector<Cell> frontier = doubts.frontier();
    if (frontier.empty() || tree_.size() + 4 * frontier.size() > max_cells_) return;
    undecided = doubts.cells();
    const std::vector<Cell> children = split_all(frontier, sure);
    undecided.insert(undecided.end(), children.begin(), children.end());
    std::erase_if(undecided, [&](Cell cell) { return !is_undecided(cell); });
  }
}

}  // namespace mapwright::navcore
