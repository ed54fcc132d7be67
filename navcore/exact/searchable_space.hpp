// Private to this folder: A free space ready to be searched.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "navcore/exact/barrier.hpp"
#include "navcore/exact/cell_locator.hpp"
#include "navcore/exact/cell_mesh.hpp"

namespace mapwright::navcore::exact {

/// Triangles, convex cells, and where they are. Immutable; stays where it was made.
class SearchableSpace {
 public:
  explicit SearchableSpace(std::shared_ptr<const Tessellation> space)
      : tessellation_(std::move(space)), mesh_(*tessellation_), locator_(mesh_) {}
  SearchableSpace(const SearchableSpace&) = delete;
  SearchableSpace& operator=(const SearchableSpace&) = delete;

  const Tessellation& tessellation() const { return *tessellation_; }
  const CellMesh& mesh() const { return mesh_; }

  /// All cells that hold p; none where p is not free.
  std::vector<std::uint32_t> cells_at(GridPoint p) const { return locator_.cells_at(p); }

  /// The connected part that holds p, as in CellMesh::components; nothing where p is not free.
  std::optional<std::uint32_t> part_at(GridPoint p) const;

  /// A free place as the start or goal that a barrier is to separate: one that lies on an outline
  /// begins on each of its free sides.
  BarrierEnd barrier_end(GridPoint p) const;

 private:
  std::shared_ptr<const Tessellation> tessellation_;
  CellMesh mesh_;
  CellLocator locator_;
};

}  // namespace mapwright::navcore::exact
