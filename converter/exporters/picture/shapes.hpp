// The obstacles of a map made ready for drawing.
#pragma once

#include <vector>

#include "converter/exporters/picture/kinds.hpp"
#include "converter/exporters/picture/view.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

/// An obstacle that meets the window. Points are on the page.
struct Shape {
  const Obstacle* obstacle = nullptr;
  ObstacleKind kind = ObstacleKind::kBuilding;
  std::vector<std::vector<Point>> rings;  ///< outline and, for an outer ring, its inner rings
  Box box = kEmptyBox;                    ///< of the obstacle
};

/// All obstacles that meet the view's window and have finite coordinates, in the order to be drawn:
/// flat things first. A ring with the token `inner_of` is a hole of the obstacle it names and no
/// shape of its own where that obstacle exists (its lines are drawn with `holes_of`).
std::vector<Shape> shapes_in_view(const Map& map, const View& view);

/// Outline of stairs: around the ends of their segments.
std::vector<Point> stairs_outline(const Obstacle& stairs);

}  // namespace mapwright::converter
