// Constrained Delaunay triangulation of line work.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "navcore/exact/line_work.hpp"

namespace mapwright::navcore::exact {

/// A triangle, counter-clockwise. Side i runs from corner i to corner i + 1.
struct Triangle {
  std::array<std::uint32_t, 3> corner{};    ///< vertex numbers of the line work
  std::array<std::int32_t, 3> neighbour{};  ///< triangle across side i; −1 on the convex hull
  std::array<std::int32_t, 3> edge{};       ///< edge of the line work along side i; −1 for none
};

/// The triangles between the edges of the line work, over the convex hull of its vertices; empty
/// where all vertices lie on one line. Every edge is a side. CGAL's exact predicates decide, so the
/// triangles are right for any input that `node` made.
std::vector<Triangle> triangulate(const LineWork& work);

/// Side of `triangle` that borders on its neighbour number `neighbour`.
inline std::size_t side_towards(const Triangle& triangle, std::int32_t neighbour) {
  return triangle.neighbour[0] == neighbour ? 0 : triangle.neighbour[1] == neighbour ? 1 : 2;
}

}  // namespace mapwright::navcore::exact
