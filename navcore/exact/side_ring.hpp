// Private to this folder: Sides of free triangles, joined to larger convex cells.
#pragma once

#include <cstdint>
#include <vector>

#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// The sides of all free triangles as rings around cells; side 3t + i is side i of triangle t.
/// `merge` takes away sides between two cells as long as what results is convex.
class SideRings {
 public:
  explicit SideRings(const Tessellation& space);

  /// Longest sides first, to within an eighth (Hertel and Mehlhorn's rule: a side goes where
  /// both its ends stay convex).
  void merge();

  std::uint32_t side_count() const { return static_cast<std::uint32_t>(twin_.size()); }
  /// False for sides of triangles that are not free, and for those taken away.
  bool exists(std::uint32_t side) const { return exists_[side] != 0; }
  std::uint32_t next(std::uint32_t side) const { return next_[side]; }
  std::uint32_t previous(std::uint32_t side) const { return previous_[side]; }
  /// The same side seen from the cell across; −1 for a wall.
  std::int32_t twin(std::uint32_t side) const { return twin_[side]; }
  std::uint32_t start(std::uint32_t side) const {
    return space_.triangles[side / 3].corner[side % 3];
  }
  GridPoint start_point(std::uint32_t side) const { return space_.work.vertices[start(side)]; }

  /// True for each vertex of the line work around which a shortest path can turn.
  std::vector<char> turning_vertices() const;

 private:
  bool stays_convex_without(std::uint32_t side) const;
  void take_away(std::uint32_t side);
  bool is_wider_than_straight(std::uint32_t first_side) const;

  const Tessellation& space_;
  std::vector<char> exists_;
  std::vector<std::int32_t> twin_;
  std::vector<std::uint32_t> next_, previous_;
};

}  // namespace mapwright::navcore::exact
