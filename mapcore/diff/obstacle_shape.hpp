// Private to this folder: the shape of an obstacle, whatever its place and number.
#pragma once

#include <cstddef>
#include <cstdint>

#include "mapcore/map.hpp"

namespace mapwright {

/// Segments in an order that does not depend on where a ring was begun: from its lowest leftmost
/// vertex. Chains that do not close, and stairs, keep their order.
struct ObstacleShape {
  std::size_t first = 0;   ///< position of the segment the order begins with
  Point anchor;            ///< its start
  std::uint64_t hash = 0;  ///< of all ends relative to the anchor, to the micrometre
  Box box = kEmptyBox;

  /// Position of the k-th segment of `count`.
  std::size_t position(std::size_t k, std::size_t count) const { return (first + k) % count; }
};

ObstacleShape shape_of(const Obstacle& obstacle);

/// True if each segment begins where the one before it ends, and the first where the last ends.
bool is_ring(const Obstacle& obstacle);

/// The same lines drawn the other way round.
Obstacle reversed(const Obstacle& obstacle);

}  // namespace mapwright
