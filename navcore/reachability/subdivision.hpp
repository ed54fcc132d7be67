// Private to this folder: splitting cells until what must be known is known.
#pragma once

#include <cstddef>
#include <vector>

#include "navcore/free_space.hpp"
#include "navcore/reachability/cell_tree.hpp"
#include "navcore/reachability/union_find.hpp"

namespace mapwright::navcore {

/// Proves what can be proved of a closed box, as far as it lies inside of the border, from the
/// clearance at its middle.
Passage prove_passage(const FreeSpace& space, const Box& cell, double radius_m);

/// Splits undecided cells of a tree.
class Subdivision {
 public:
  Subdivision(const FreeSpace& space, double radius_m, std::size_t max_cells, CellTree& tree)
      : space_(space), radius_m_(radius_m), max_cells_(max_cells), tree_(tree) {}

  /// Until all undecided cells are at most this wide.
  void split_to(double resolution_m);

  /// Until it is clear which areas of free cells are connected, or only cells of the finest kind
  /// leave it open. `sure` holds free cells that share a side.
  void decide_connections(UnionFind& sure);

 private:
  using Cell = CellTree::Cell;
  struct Doubts;

  bool is_free(Cell cell) const { return tree_.passage(cell) == Passage::kFree; }
  bool is_undecided(Cell cell) const {
    return tree_.is_leaf(cell) && tree_.passage(cell) == Passage::kUndecided;
  }
  void prove(Cell cell);
  std::vector<Cell> undecided_cells() const;
  std::vector<Cell> split_all(const std::vector<Cell>& cells, UnionFind& sure);

  const FreeSpace& space_;
  double radius_m_;
  std::size_t max_cells_;
  CellTree& tree_;
};

}  // namespace mapwright::navcore
