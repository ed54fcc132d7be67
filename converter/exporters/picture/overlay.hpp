// Drawing what is laid over a map.
#pragma once

#include <vector>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/view.hpp"

namespace mapwright::converter {

void draw_overlay(Canvas& canvas, const View& view, const std::vector<OverlayItem>& items);

void draw_field(Canvas& canvas, const View& view, const ColourField& field);

/// The item drawn small, for the legend: `box` is the room it has on the page.
void draw_sample(Canvas& canvas, const Box& box, const OverlayItem& item);

}  // namespace mapwright::converter
