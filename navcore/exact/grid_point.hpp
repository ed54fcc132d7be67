// Points on the millimetre grid, and the exact questions one can ask of them.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

#include "mapcore/point.hpp"

namespace mapwright::navcore::exact {

/// A point with whole millimetres as coordinates, relative to the origin of a GridFrame.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(GridPoint, GridPoint) = default;
  friend constexpr auto operator<=>(GridPoint, GridPoint) = default;
};

/// Coordinates lie within ±kGridLimit: differences then fit 31 bits, and `orient` and `dot_from`
/// cannot overflow.
inline constexpr std::int32_t kGridLimit = 1'000'000'000;

/// Map coordinates are read up to this from the centre of the border (500 km). The rest up to
/// kGridLimit is room for offsets.
inline constexpr std::int32_t kMapLimit = 500'000'000;

/// Twice the signed area of the triangle a, b, c: positive where c lies to the left of a→b. Exact.
constexpr std::int64_t orient(GridPoint a, GridPoint b, GridPoint c) {
  const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
  const std::int64_t acx = std::int64_t{c.x} - a.x, acy = std::int64_t{c.y} - a.y;
  return abx * acy - aby * acx;
}

/// (b − a) · (c − a). Exact.
constexpr std::int64_t dot_from(GridPoint a, GridPoint b, GridPoint c) {
  const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
  const std::int64_t acx = std::int64_t{c.x} - a.x, acy = std::int64_t{c.y} - a.y;
  return abx * acx + aby * acy;
}

/// |ab|², mm². Exact.
constexpr std::int64_t squared_distance(GridPoint a, GridPoint b) {
  return dot_from(a, b, b);
}

/// |ab| in mm, correctly rounded but for the last bits of a square root.
inline double distance_mm(GridPoint a, GridPoint b) {
  const double dx = static_cast<double>(std::int64_t{b.x} - a.x);
  const double dy = static_cast<double>(std::int64_t{b.y} - a.y);
  return std::sqrt(dx * dx + dy * dy);
}

/// True if p lies on the closed segment ab. Exact.
constexpr bool is_on_segment(GridPoint p, GridPoint a, GridPoint b) {
  return orient(a, b, p) == 0 && dot_from(p, a, b) <= 0;
}

/// Ties the millimetre grid to map coordinates: the grid's origin is a whole millimetre of the map
/// frame, so that maps written with millimetres are taken over without any rounding.
class GridFrame {
 public:
  GridFrame() = default;
  /// `origin`: metres, map frame; rounded to whole millimetres.
  explicit GridFrame(Point origin)
      : origin_mm_{std::nearbyint(origin.x * 1e3), std::nearbyint(origin.y * 1e3)} {}

  /// True if `p` is finite and within kMapLimit of the origin.
  bool can_hold(Point p) const {
    return std::abs(p.x * 1e3 - origin_mm_.x) <= kMapLimit &&
           std::abs(p.y * 1e3 - origin_mm_.y) <= kMapLimit;
  }

  /// Nearest grid point. Requires can_hold(p).
  GridPoint to_grid(Point p) const {
    return {static_cast<std::int32_t>(std::nearbyint(p.x * 1e3) - origin_mm_.x),
            static_cast<std::int32_t>(std::nearbyint(p.y * 1e3) - origin_mm_.y)};
  }

  /// Metres, map frame.
  Point to_map(GridPoint p) const {
    return {(p.x + origin_mm_.x) / 1e3, (p.y + origin_mm_.y) / 1e3};
  }

 private:
  Point origin_mm_;
};

}  // namespace mapwright::navcore::exact
