// Steps laid across stairs of which only the outline or the centre line is drawn.
#pragma once

#include "converter/pipeline/stairs.hpp"

namespace mapwright::converter {

/// Risers of stairs that fill `outline` (any orientation) and rise towards `up` (unit vector):
/// `count` of them, one tread apart, the first at the foot. Each runs from side to side of the
/// outline with lower ground on its right.
std::vector<std::vector<Point>> risers_in_outline(const std::vector<Point>& outline, Point up,
                                                  int count);

/// Risers across a centre line drawn upwards: `count` of them, `width_m` wide.
std::vector<std::vector<Point>> risers_across_line(const std::vector<Point>& line, double width_m,
                                                   int count);

}  // namespace mapwright::converter
