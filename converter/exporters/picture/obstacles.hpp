// Drawing the obstacles.
#pragma once

#include <vector>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/shapes.hpp"

namespace mapwright::converter {

/// Robots drive on ramps: what is told of their places shows where they have no fill.
enum class RampFill { kColoured, kNone };

/// Fills and lines. Segments indoors are dashed.
void draw_shapes(Canvas& canvas, const View& view, const std::vector<Shape>& shapes,
                 RampFill ramps);

/// Short strokes on the free side (the right of a→b) of every segment long enough to carry one.
void draw_orientation_ticks(Canvas& canvas, const View& view, const std::vector<Shape>& shapes);

/// An arrow from `from` to `to`, with a head that fits its length.
void draw_arrow(Canvas& canvas, Point from, Point to, const Stroke& stroke);

}  // namespace mapwright::converter
