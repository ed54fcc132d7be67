// A point of the map's plane on the grid of its resolution.
#pragma once

#include <cstdint>

namespace mapwright {

/// Coordinates in whole units of the last decimal of a resolution (text::DecimalFormat): at 1 mm
/// they reach 2,147 km. Half the size of a Point, and text without arithmetic in doubles.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

}  // namespace mapwright
