// The definition of a simple ring, worked out in exact arithmetic.
#pragma once

#include <span>

#include "mapcore/point.hpp"

namespace mapwright::bench {

/// True if the edges of the ring have length and meet nowhere but at the shared ends of neighbours:
/// every pair of edges is intersected in CGAL's exact kernel, no filter or sweep of ours between.
/// For rings of three vertices and more. Quadratic.
bool is_simple_exactly(std::span<const Point> ring);

}  // namespace mapwright::bench
