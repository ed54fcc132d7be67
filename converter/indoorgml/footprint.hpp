// Private to this folder: where a cell stands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/indoorgml/indoor_document.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

/// The floor of a cell, seen from above.
struct Footprint {
  std::vector<Face> faces;           ///< tile the floor; z as in the document
  std::optional<double> floor, top;  ///< z of the lowest corner and the highest one of the cell
  double area = 0.0;                 ///< of the floor, square units of the coordinates
};

/// Of a solid: the faces that look down, told by the sign of its volume, so that the winding of its
/// faces does not matter as long as they agree; where they do not, the faces in its lower half. Of
/// polygons without heights: themselves. Nothing for a cell without a floor.
std::optional<Footprint> footprint_of(const IndoorObject& cell);

/// Twice the signed area of a ring seen from above: positive for counter-clockwise ones.
double doubled_area(const VertexPath& ring);

}  // namespace mapwright::converter
