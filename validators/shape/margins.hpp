// How much room there is between obstacles and the border.
#pragma once

#include <array>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// Distances of a box from the border's left, top, right and bottom; metres, negative beyond it.
inline std::array<double, 4> margins_m(const Border& border, const Box& box) {
  return {box.min_x - border.left, border.top - box.max_y, border.right - box.max_x,
          box.min_y - border.bottom};
}

}  // namespace mapwright::validators
