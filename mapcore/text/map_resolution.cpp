#include "mapcore/text/map_resolution.hpp"

#include "mapcore/text/decimal_format.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright {
namespace {

bool fits(const Map& map, const text::DecimalFormat& format) {
  const auto is_multiple = [&](double value) { return format.rounded(value) == value; };
  const Border& b = map.border;
  for (const double value : {b.left, b.top, b.right, b.bottom}) {
    if (!is_multiple(value)) return false;
  }
  for (const auto& obstacle : map.obstacles) {
    for (const auto& s : obstacle.segments) {
      for (const double value : {s.a.x, s.a.y, s.b.x, s.b.y, s.height_m}) {
        if (!is_multiple(value)) return false;
      }
    }
  }
  return true;
}

}  // namespace

double resolution_of(const Map& map) {
  for (const double resolution : {tolerance::kResolution_m, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    if (fits(map, text::DecimalFormat(resolution))) return resolution;
  }
  return 1e-9;
}

}  // namespace mapwright
