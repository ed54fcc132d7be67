// Private to this folder: which obstacle of one map is which of another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapcore/diff/map_diff.hpp"
#include "mapcore/diff/obstacle_shape.hpp"

namespace mapwright {

/// The obstacles of a map with their shapes, in the same order.
struct ShapedMap {
  const Map* map;
  std::vector<ObstacleShape> shapes;

  explicit ShapedMap(const Map& m);
};

inline constexpr std::uint32_t kNoPartner = UINT32_MAX;

/// For each obstacle of the old map the position of its partner in the new one, or kNoPartner. No
/// two have the same partner.
std::vector<std::uint32_t> match_obstacles(const ShapedMap& before, const ShapedMap& after,
                                           const MapDiffOptions& options);

}  // namespace mapwright
