// Private to this folder: how an obstacle differs from what it was.
#pragma once

#include "mapcore/diff/map_diff.hpp"
#include "mapcore/diff/obstacle_shape.hpp"

namespace mapwright {

struct ShapedObstacle {
  const Obstacle& obstacle;
  const ObstacleShape& shape;
  const Semantic& semantic;  ///< of the obstacle, with ids translated
};

/// Fills everything but the positions.
ObstacleChange compare(const ShapedObstacle& before, const ShapedObstacle& after,
                       double tolerance_m);

}  // namespace mapwright
