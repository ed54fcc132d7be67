// The plane cut into triangles, each free or blocked.
#pragma once

#include <vector>

#include "navcore/exact/triangulation.hpp"

namespace mapwright::navcore::exact {

/// Line work, the triangles between its edges, and where a robot can be.
struct Tessellation {
  LineWork work;
  std::vector<Triangle> triangles;
  std::vector<char> is_free;  ///< by triangle: 1 if the robot can be there
  std::vector<char> is_wall;  ///< by edge: 1 if it stops a robot that is free on both sides of it

  GridPoint corner(std::size_t triangle, std::size_t i) const {
    return work.vertices[triangles[triangle].corner[i]];
  }

  /// True if side `i` of a free triangle can be crossed.
  bool is_open(std::size_t triangle, std::size_t i) const {
    const std::int32_t across = triangles[triangle].neighbour[i],
                       edge = triangles[triangle].edge[i];
    return across >= 0 && is_free[across] != 0 && (edge < 0 || is_wall[edge] == 0);
  }
};

}  // namespace mapwright::navcore::exact
