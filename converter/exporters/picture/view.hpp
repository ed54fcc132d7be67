// Where things of the map come to lie on the page.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// The map's window laid onto a panel of the page (points, y down).
struct View {
  Box window;  ///< metres, map frame
  Box panel;   ///< points, page
  double pt_per_m = 1.0;

  Point to_page(Point p) const {
    return {on_paper(panel.min_x + (p.x - window.min_x) * pt_per_m),
            on_paper(panel.min_y + (window.max_y - p.y) * pt_per_m)};
  }
  std::vector<Point> to_page(const std::vector<Point>& points) const;

  /// Thinner lines where the map is small on the page: 1 down to 20 cm a point, 0.3 from 5 m on.
  double line_scale() const;

 private:
  // The drawing library's numbers end at 2^23; what lies farther away is out of sight anyhow.
  static double on_paper(double pt) { return std::clamp(pt, -4.0e6, 4.0e6); }
};

/// The number 1, 2 or 5 times a power of ten that is nearest below or at `value`; value > 0.
double round_step(double value);

/// A number without needless digits: "0.45", "14", "1200".
std::string plain_number(double value);

}  // namespace mapwright::converter
