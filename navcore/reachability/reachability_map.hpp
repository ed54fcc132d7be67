// Which parts of the free space a robot can reach from which: proofs in both directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "navcore/free_space.hpp"
#include "navcore/reachability/cell_tree.hpp"
#include "navcore/reachability/union_find.hpp"

namespace mapwright::navcore {

struct ReachabilityOptions {
  double radius_m = 0.0;  ///< of the robot, a disc

  /// Width of the cells that areas are measured with; 0 chooses 1/2000 of the border's longer side,
  /// but at least 5 cm.
  double resolution_m = 0.0;

  /// Where cells of that width leave it open whether two areas are connected, they are split down
  /// to this width. A passage is decided unless its width is within about three times this of the
  /// robot's.
  double finest_m = 0.002;

  std::size_t max_cells = 8000000;  ///< memory limit: 16 bytes each; then the rest stays undecided
  double min_area_m2 = 0.05;        ///< smaller areas are not listed
};

enum class Connection { kYes, kNo, kUndecided };

/// A part of the places for the robot's centre that no way leads out of.
struct ReachableArea {
  double area_m2 = 0.0;       ///< of the cells proved free: a lower bound
  Point at;                   ///< centre of its largest cell
  Box box{};                  ///< around the cells proved free
  bool is_connected = false;  ///< proved: from every proved place of it to every other
};

/// Subdivides the map until each cell is proved free for the robot's centre (clearance in the
/// middle at least radius + half a diagonal), or proved blocked (less than radius − half a
/// diagonal, or solid as far as the cell reaches), or is as small as asked. Free cells that share a
/// side are certainly connected; areas that no chain of free and undecided cells joins are
/// certainly not.
///
/// Uses clearance and solidity only, so crossing and overlapping obstacles do no harm. For a point
/// robot no cell on a thin wall is ever proved blocked: such separations stay undecided.
///
/// The idea is that of Zhu and Latombe (New Heuristic Algorithms for Efficient Hierarchical Path
/// Planning, 1991) and of Wang, Chiang and Yap (On Soft Predicates in Subdivision Motion Planning,
/// 2015). Immutable once built; safe to query from many threads.
class ReachabilityMap {
 public:
  /// `space` must outlive this. Requires radius_m ≥ 0.
  ReachabilityMap(const FreeSpace& space, const ReachabilityOptions& options);

  /// Largest first; those of `min_area_m2` and more.
  const std::vector<ReachableArea>& areas() const { return areas_; }

  /// Share of the largest area in all that is proved free, in [0, 1]; 0 where nothing is.
  double largest_fraction() const;

  double free_area_m2() const { return free_area_m2_; }  ///< proved, smallest ones included
  double undecided_area_m2() const { return undecided_area_m2_; }  ///< in or beside free space

  /// Whether the robot can get from a to b. kNo also where it cannot stand at one of them.
  Connection connected(Point a, Point b) const;

  /// Position in areas() of the area that p is proved to belong to.
  std::optional<std::size_t> area_at(Point p) const;

  double resolution_m() const { return resolution_m_; }
  std::size_t cell_count() const { return tree_.size(); }

 private:
  // What holds a point: its group of cells that may be connected and, if proved, of those that are.
  struct Anchor {
    std::uint32_t possible = CellTree::kNone;
    std::uint32_t sure = CellTree::kNone;
  };

  void label();
  void list_areas();
  Anchor anchor(Point p) const;
  std::uint32_t free_cell_in_sight(Point p, CellTree::Cell from) const;

  const FreeSpace* space_;
  double radius_m_;
  double resolution_m_;
  CellTree tree_;
  UnionFind sure_;      // over free cells
  UnionFind possible_;  // over free and undecided cells
  std::vector<ReachableArea> areas_;
  std::vector<std::uint32_t> area_groups_;  // of areas_: representative in possible_
  double free_area_m2_ = 0.0;
  double undecided_area_m2_ = 0.0;
};

}  // namespace mapwright::navcore
