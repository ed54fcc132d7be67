// What an obstacle is to the eye: its kind, and the colours of that kind.
#pragma once

#include <string_view>
#include <vector>

#include "converter/exporters/picture.hpp"

namespace mapwright::converter {

/// In the order they are drawn and stand in the legend.
enum class ObstacleKind {
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

struct KindStyle {
  std::string_view name;  ///< in the legend
  Colour fill;            ///< opacity 0: lines only
  Colour line;
  double width_pt;
};

ObstacleKind obstacle_kind(const Obstacle& obstacle);
const KindStyle& kind_style(ObstacleKind kind);
const std::vector<ObstacleKind>& all_obstacle_kinds();

/// Fill of one obstacle: the kind's, darker for higher buildings.
Colour fill_colour(const Obstacle& obstacle, ObstacleKind kind);

}  // namespace mapwright::converter
