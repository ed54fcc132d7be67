// Private to this folder: Finds the cells that hold a point.
#pragma once

#include <cstdint>
#include <vector>

#include "navcore/exact/cell_mesh.hpp"

namespace mapwright::navcore::exact {

/// Buckets over the cells of a mesh. Keeps a reference to the mesh; immutable once built.
class CellLocator {
 public:
  explicit CellLocator(const CellMesh& mesh);

  /// All cells whose closed area holds p, ascending; none where p is not free. Exact.
  std::vector<std::uint32_t> cells_at(GridPoint p) const;

 private:
  struct Reach {
    std::size_t first_column, last_column;
  };
  void choose_size();
  std::size_t row(double y) const;
  std::size_t column(double x) const;
  template <class Visit>
  void for_each_bucket(std::uint32_t cell, Visit visit) const;
  void widen(Reach& reach, GridPoint a, GridPoint b, std::size_t row) const;

  const CellMesh& mesh_;
  double min_x_ = 0.0, min_y_ = 0.0, max_x_ = -1.0, max_y_ = -1.0;
  double bucket_mm_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> cells_;
};

}  // namespace mapwright::navcore::exact
