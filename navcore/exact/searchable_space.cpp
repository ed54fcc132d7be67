#include "navcore/exact/searchable_space.hpp"

namespace mapwright::navcore::exact {
namespace {

// From a point of a convex cell into the cell.
Direction inwards(const CellMesh& mesh, std::uint32_t cell, GridPoint p) {
  Direction sum;
  for (std::uint32_t i = mesh.first_corner(cell); i < mesh.end_corner(cell); ++i) {
    sum.x += std::int64_t{mesh.corners()[i].point.x} - p.x;
    sum.y += std::int64_t{mesh.corners()[i].point.y} - p.y;
  }
  return sum;
}

}  // namespace

std::optional<std::uint32_t> SearchableSpace::part_at(GridPoint p) const {
  const auto cells = cells_at(p);
  if (cells.empty()) return std::nullopt;
  return mesh_.components()[cells[0]];
}

BarrierEnd SearchableSpace::barrier_end(GridPoint p) const {
  BarrierEnd end{p, {}};
  bool is_on_wall = false;
  for (const std::uint32_t cell : cells_at(p)) {
    is_on_wall = is_on_wall || mesh_.is_on_wall(cell, p);
    end.ways_off.push_back(inwards(mesh_, cell, p));
  }
  if (!is_on_wall) end.ways_off.clear();
  return end;
}

}  // namespace mapwright::navcore::exact
