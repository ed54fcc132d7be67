#include "navcore/engine/iso_line.hpp"

#include <algorithm>
#include <cstddef>

namespace mapwright::navcore::engine {
namespace {

// Points where the footprint's outline passes from below the height to the other side, sorted along
// the contour. `at_height_is_below` says where vertices exactly at the height belong: taken both
// ways, the two sets together make the footprint closed.
std::vector<Point> crossings(const SceneRamp& ramp, double height_m, bool at_height_is_below) {
  const auto is_below = [&](double above_m) {
    return above_m < 0.0 || (at_height_is_below && above_m == 0.0);
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < ramp.footprint.size(); ++i) {
    const Point p = ramp.footprint[i];
    const Point q = ramp.footprint[(i + 1) % ramp.footprint.size()];
    const double p_above = ramp.plane.height_m(p) - height_m;
    const double q_above = ramp.plane.height_m(q) - height_m;
    if (is_below(p_above) == is_below(q_above)) continue;
    points.push_back(p + (p_above / (p_above - q_above)) * (q - p));
  }
  const Point uphill = ramp.plane.gradient();
  const Point along{-uphill.y, uphill.x};
  std::sort(points.begin(), points.end(),
            [&](Point p, Point q) { return dot(along, p) < dot(along, q); });
  return points;
}

}  // namespace

std::vector<OneSidedSegment> iso_lines(const SceneRamp& ramp, double height_m) {
  std::vector<OneSidedSegment> lines;
  const std::vector<Point> points = crossings(ramp, height_m, false);
  const std::vector<Point> others = crossings(ramp, height_m, true);
  const auto add = [&](const std::vector<Point>& ends) {
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      if (ends[i] != ends[i + 1]) lines.push_back({ends[i], ends[i + 1]});
    }
  };
  add(points);
  if (others != points) add(others);
  return lines;
}

}  // namespace mapwright::navcore::engine
