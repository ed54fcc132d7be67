// Turns that doubles can decide.
#pragma once

#include <cfloat>
#include <cmath>

#include "mapcore/point.hpp"

namespace mapwright {

/// Bound of the relative error of the 2 × 2 determinant of differences (Shewchuk, Adaptive
/// Precision Floating-Point Arithmetic, 1997: ccwerrboundA).
inline constexpr double kTurnError = (3.0 + 16.0 * (DBL_EPSILON / 2.0)) * (DBL_EPSILON / 2.0);

/// Error bounds hold where nothing underflows or overflows on the way.
constexpr bool in_safe_range(double magnitude) {
  return magnitude > 1e-280 && magnitude < 1e280;
}

/// The sign of u × v where u and v are differences from one common point; 0 where rounding might
/// have changed it, and where it is 0.
inline int sure_sign_of_cross(Point u, Point v) {
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  const double determinant = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  if (!in_safe_range(magnitude) || std::abs(determinant) <= kTurnError * magnitude) return 0;
  return determinant > 0.0 ? 1 : -1;
}

/// The side of p as seen from a towards b, 1 for left and -1 for right; 0 where doubles cannot tell
/// (`turn` can).
inline int sure_turn(Point a, Point b, Point p) {
  return sure_sign_of_cross(b - a, p - a);
}

}  // namespace mapwright
