// The square places that a field of values is given for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mapcore/point.hpp"

namespace mapwright::navcore {

/// Cells of one size over a window, row by row from the lower left corner; the last column and row
/// may reach beyond the window.
struct PlaceGrid {
  Point corner;  ///< lower left
  double cell_m = 0.5;
  std::size_t columns = 0;
  std::size_t rows = 0;

  /// Requires a window that is not empty and a positive cell.
  static PlaceGrid over(const Box& window, double cell_m) {
    const auto cells = [&](double length_m) {
      return static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / cell_m - 1e-9)));
    };
    return {{window.min_x, window.min_y}, cell_m, cells(window.width()), cells(window.height())};
  }

  std::size_t size() const { return columns * rows; }
  double cell_area_m2() const { return cell_m * cell_m; }

  Point center(std::size_t i) const {
    return {corner.x + cell_m * (static_cast<double>(i % columns) + 0.5),
            corner.y + cell_m * (static_cast<double>(i / columns) + 0.5)};
  }
  Box box(std::size_t i) const {
    const Point c = center(i);
    return Box{c.x, c.y, c.x, c.y}.inflated(0.5 * cell_m);
  }
};

}  // namespace mapwright::navcore
