// What stands around a map: grid and axes, border, scale bar, north arrow.
#pragma once

#include <string>
#include <vector>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/shapes.hpp"

namespace mapwright::converter {

/// The panel's ground: grey outside of the border, paper within; grid lines.
void draw_ground(Canvas& canvas, const View& view, const Border& border);

/// The border of the map as a line.
void draw_border(Canvas& canvas, const View& view, const Border& border);

/// The panel's frame with the coordinates of the grid lines (metres) beside it.
void draw_axes(Canvas& canvas, const View& view);

/// A bar of a round length; `right_end` is its upper right corner on the page.
void draw_scale_bar(Canvas& canvas, const View& view, Point right_end);

/// An arrow to true north (counter-clockwise from +x of the map) around a point of the page.
void draw_north_arrow(Canvas& canvas, Point centre, double north_deg);

}  // namespace mapwright::converter
