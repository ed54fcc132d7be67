// The angle between two lines.
#pragma once

#include <cmath>
#include <numbers>

#include "mapcore/map.hpp"

namespace mapwright::validators {

/// Angle between the lines of two segments, degrees in [0, 90].
inline double line_angle_deg(const Segment& s, const Segment& t) {
  const Point u = s.b - s.a, v = t.b - t.a;
  return std::atan2(std::abs(cross(u, v)), std::abs(dot(u, v))) * 180.0 / std::numbers::pi;
}

}  // namespace mapwright::validators
