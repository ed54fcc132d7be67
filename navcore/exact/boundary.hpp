// Private to this folder: What bounds the free space.
#pragma once

#include <cstdint>
#include <vector>

#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// An edge of the line work as seen from a free triangle: free space lies on the left of from→to.
struct BoundarySide {
  std::uint32_t from = 0, to = 0;  ///< vertices
  std::uint32_t edge = 0;
  std::uint32_t triangle = 0;  ///< the free triangle on its left
};

/// A closed chain of sides: each begins where the last one ends.
using BoundaryCycle = std::vector<BoundarySide>;

/// The boundary of the free space: outer boundaries counter-clockwise, those of holes clockwise. A
/// wall that is free on both sides is passed twice, once in each direction. In the order of the
/// triangles.
std::vector<BoundaryCycle> boundary_cycles(const Tessellation& space);

}  // namespace mapwright::navcore::exact
