// The colours of kinds of obstacles.
#pragma once

#include "converter/exporters/picture.hpp"
#include "mapcore/obstacle_kind.hpp"

namespace mapwright::converter {

struct KindStyle {
  Colour fill;  ///< opacity 0: lines only
  Colour line;
  double width_pt;
};

const KindStyle& kind_style(ObstacleKind kind);

/// Fill of one obstacle: the kind's, darker for higher buildings.
Colour fill_colour(const Obstacle& obstacle, ObstacleKind kind);

}  // namespace mapwright::converter
