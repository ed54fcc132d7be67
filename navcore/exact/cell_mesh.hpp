// Private to this folder: The free space as convex cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// A corner of a cell, and the side from it to the cell's next corner (counter-clockwise).
struct Corner {
  GridPoint point;
  std::uint32_t vertex = 0;  ///< number within the mesh
  std::int32_t twin = -1;    ///< the same side as a corner of the cell across; −1 for a wall
};

/// Convex cells that cover the free space and overlap nowhere. A side between two cells can be
/// crossed, a side without twin is a wall (or the border). A cell may have corners of 180°.
///
/// Corners of all cells are stored one after the other. Immutable once built.
class CellMesh {
 public:
  explicit CellMesh(const Tessellation& space);

  std::size_t cell_count() const { return first_corner_.size() - 1; }
  std::size_t vertex_count() const { return can_turn_.size(); }
  std::span<const Corner> corners() const { return corners_; }
  std::uint32_t first_corner(std::uint32_t cell) const { return first_corner_[cell]; }
  std::uint32_t end_corner(std::uint32_t cell) const { return first_corner_[cell + 1]; }
  std::uint32_t cell_of(std::int32_t corner) const { return cell_of_corner_[corner]; }

  /// True for vertices around which a shortest path can turn: some free angle there exceeds 180°.
  bool can_turn_at(std::uint32_t vertex) const { return can_turn_[vertex] != 0; }

  /// True if the closed cell holds p. Exact.
  bool contains(std::uint32_t cell, GridPoint p) const;

  /// True if p lies on a side of the cell that cannot be crossed. Exact.
  bool is_on_wall(std::uint32_t cell, GridPoint p) const;

  /// Dead ends: a pocket is a cell from which the rest of the mesh is reached through one side
  /// only, when other pockets are taken away. Gives the cell on that side; the cell itself where it
  /// is no pocket. A path enters a pocket only to end there.
  std::uint32_t way_out(std::uint32_t cell) const { return way_out_[cell]; }

  /// Area of all cells, m².
  double area_m2() const;

  /// Area of one cell, m².
  double area_m2(std::uint32_t cell) const;

  /// For each cell the number of its connected component, 0 for the one with the largest area, then
  /// descending.
  const std::vector<std::uint32_t>& components() const { return component_; }
  const std::vector<double>& component_areas_m2() const { return component_area_m2_; }

 private:
  void find_pockets();
  void find_components();
  double number_component(std::uint32_t seed);
  void rank_components();

  std::vector<Corner> corners_;
  std::vector<std::uint32_t> cell_of_corner_;
  std::vector<std::uint32_t> first_corner_;
  std::vector<char> can_turn_;
  std::vector<std::uint32_t> way_out_;
  std::vector<std::uint32_t> component_;
  std::vector<double> component_area_m2_;
};

}  // namespace mapwright::navcore::exact
