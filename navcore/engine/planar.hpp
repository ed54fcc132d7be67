// Private to this folder: small constructions on segments in the plane.
#pragma once

#include <array>
#include <optional>

#include "mapcore/point.hpp"

namespace mapwright::navcore::engine {

/// Left of a→b positive, right negative: twice the area of the triangle a, b, p.
constexpr double side_of_line(Point a, Point b, Point p) {
  return cross(b - a, p - a);
}

struct Chord {
  Point a, b;
};

/// The part of ab within the circle around the origin; its ends are a and b to the bit where they
/// lie inside. Nothing where ab keeps clear of the circle. Requires a != b.
std::optional<Chord> clipped_to_circle(Point a, Point b, double radius_m);

/// A square around the origin.
struct Square {
  double half_m = 0.0;

  /// Counter-clockwise from the lower left.
  constexpr std::array<Point, 4> corners() const {
    return {{{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}}};
  }

  /// True if the closed square and the closed segment have a point in common.
  bool meets(Point a, Point b) const;

  enum class Side { kLeft, kRight, kBoth };

  /// Where the square lies as seen along a→b; touching the line does not count as crossing it.
  Side side(Point a, Point b) const;
};

}  // namespace mapwright::navcore::engine
