// Private to this folder: which outlines are polygons, and which are holes of which.
#pragma once

#include <cstddef>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::converter {

/// What becomes of each obstacle.
struct RingGroups {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<bool> is_ring;                    ///< a simple closed outline
  std::vector<std::size_t> outer_of;            ///< of a hole: its outline's position; else kNone
  std::vector<std::vector<std::size_t>> holes;  ///< of an outline, by position
};

/// Ties holes to outlines by `inner_of`, else by nesting: the smallest solid around a clockwise
/// outline. Only where outline and holes are a sound polygon together; not at all without
/// `join_holes`.
RingGroups ring_groups(const Map& map, bool join_holes);

}  // namespace mapwright::converter
