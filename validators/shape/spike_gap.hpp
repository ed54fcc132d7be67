// How near the arms of a corner come to each other.
#pragma once

#include <algorithm>
#include <cmath>

#include "mapcore/point.hpp"

namespace mapwright::validators {

/// Tangent of the sharpest corner that is no spike whatever its arms: about 10°.
inline constexpr double kSharp = 0.18;

/// True if the angle between the arms u and v of a corner is smaller, but they do not lie on each
/// other (G104 tells of those).
inline bool is_sharp(Point u, Point v) {
  const double along = dot(u, v), across = std::abs(cross(u, v));
  // First what nearly always tells: at right angles the sign of `along` is anybody's guess.
  return !(across > kSharp * along) && !(along <= 0.0) && across != 0.0;
}

/// Distance between the arms of a corner where the shorter one ends; infinite where they open wide
/// or the corner is smaller than the limit itself.
inline double spike_gap_m(Point u, Point v, double limit_m) {
  if (!is_sharp(u, v)) return HUGE_VAL;
  const double shorter_m = std::min(length(u), length(v)),
               longer_m = std::max(length(u), length(v));
  return shorter_m <= limit_m ? HUGE_VAL : std::abs(cross(u, v)) / longer_m;
}

}  // namespace mapwright::validators
