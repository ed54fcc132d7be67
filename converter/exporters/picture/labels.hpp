// Words and numbers beside the obstacles.
#pragma once

#include <vector>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/shapes.hpp"

namespace mapwright::converter {

/// Writes heights, ids or names where there is room: within a shape where it is large enough, else
/// beside it where nothing else is. Larger shapes come first.
void draw_labels(Canvas& canvas, const View& view, const std::vector<Shape>& shapes,
                 PictureLabels labels);

/// A box within `box` and the even-odd area of the rings, as wide as can be found at one of a few
/// levels, for something `height_pt` high: its middle and the width there is; width 0 where there
/// is none.
struct Room {
  Point middle;
  double width_pt = 0.0;
};
Room widest_room(const std::vector<std::vector<Point>>& rings, const Box& box, double height_pt);

}  // namespace mapwright::converter
