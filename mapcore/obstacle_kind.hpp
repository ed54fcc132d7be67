// What an obstacle is to the eye.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright {

/// In the order they are drawn: what lies flat first.
enum class ObstacleKind : std::uint8_t {
  kRamp,
  kStairs,
  kLowSolid,  ///< benches, planters: lower than a person
  kGreen,     ///< trees, hedges, planters: by their labels
  kBuilding,
  kColumn,  ///< high, but less than a few square metres
  kRoom,    ///< a clockwise ring: a courtyard, or a room seen from inside
  kWall,
  kLowWall,  ///< so low that many a laser passes over
};

ObstacleKind obstacle_kind(const Obstacle& obstacle);

/// "low obstacle", for legends.
std::string_view to_string(ObstacleKind kind);

/// All kinds, in the order of legends.
const std::vector<ObstacleKind>& all_obstacle_kinds();

}  // namespace mapwright
