// Private to this folder: Euclidean shortest paths over the cells of a mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navcore/exact/cell_mesh.hpp"

namespace mapwright::navcore::exact {

/// A polyline on the grid; its inner points are corners of the free space around which it turns.
struct GridPath {
  std::vector<GridPoint> points;  ///< first start, last goal; a single point where they are equal
  double length_mm = 0.0;
};

/// What one search works with. Reusing it for the next search saves allocating it; not to be shared
/// by threads.
class SearchSpace {
 public:
  /// Counters of the last search.
  struct Effort {
    std::size_t expanded = 0;
    std::size_t pushed = 0;
  };
  Effort effort;

 private:
  friend class PathSearch;

  // A point around which paths turn, and the shortest way known to it.
  struct Root {
    GridPoint point;
    std::uint32_t vertex;
    std::uint32_t parent;  // root before; itself for the start
    double g_mm;
  };
  // A directed line through two grid points, so that sides of it are exact.
  struct Ray {
    GridPoint from, to;
    std::int64_t side_of(GridPoint p) const { return orient(from, to, p); }
  };
  // The part of a cell's side that is seen from a root, about to enter the cell.
  struct Node {
    std::uint32_t root;
    std::int32_t corner;             // of the cell to enter; −1: the goal is reached
    Ray left, right;                 // what bounds the view
    bool left_is_end, right_is_end;  // the view reaches the ends of the side
    Point left_end, right_end;       // mm
    double f_mm;
  };
  struct Queued {
    double f_mm;
    std::uint32_t node;
  };
  struct Best {
    std::uint32_t search = 0;
    double g_mm = 0.0;
  };

  void begin(const CellMesh& mesh);

  std::uint32_t search_ = 0;
  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  std::vector<Queued> queue_;
  std::vector<Best> best_;                  // by vertex
  std::vector<std::uint32_t> goal_search_;  // by cell: search whose goal it leads to or holds
  std::vector<Node> successors_;
};

/// Finds a shortest path from start to goal, which stays in the closed cells and crosses no wall:
/// it may touch walls and run along them. Nothing where there is none.
///
/// Polyanya (Cui, Harabor, Grastien: Compromise-free pathfinding on a navigation mesh, IJCAI 2017)
/// with two changes: a view is bounded by rays through two grid points each, so that every question
/// of sides is an exact integer sign; and dead ends that do not hold the goal are never entered.
/// Only lengths are rounded (double precision), so the path is feasible always, and shortest up to
/// about 1e-12 relative. Deterministic.
///
/// `start_cells` and `goal_cells`: all cells that hold the points (CellLocator::cells_at).
std::optional<GridPath> find_shortest_path(const CellMesh& mesh, GridPoint start, GridPoint goal,
                                           std::span<const std::uint32_t> start_cells,
                                           std::span<const std::uint32_t> goal_cells,
                                           SearchSpace& space);

}  // namespace mapwright::navcore::exact
