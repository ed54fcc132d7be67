// Private to this folder: whether a ring is simple, told quickly and on the safe side.
#pragma once

#include <span>

#include "mapcore/point.hpp"

namespace mapwright::navcore::engine {

enum class RingShape { kUnclear, kClockwise, kCounterClockwise };

/// Orientation of a ring (its first vertex is not repeated) that is simple beyond rounding: edges
/// that do not join keep clear of each other. kUnclear for every other ring and for rings of more
/// than 2000 vertices: no statement, which costs speed and nothing else.
///
/// Quadratic, but nearly all pairs of edges part by their boxes. mapcore's is_simple_ring answers
/// exactly; that costs seconds for the millions of rings of a city.
RingShape ring_shape(std::span<const Point> ring);

}  // namespace mapwright::navcore::engine
