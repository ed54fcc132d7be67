// Angles that say their unit.
#pragma once

#include <cmath>
#include <numbers>

#include "mapcore/point.hpp"

namespace mapwright {

/// A plane angle, counter-clockwise positive, 0 along +x.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle from_radians(double radians) { return Angle(radians); }
  static constexpr Angle from_degrees(double degrees) {
    return Angle(degrees * (std::numbers::pi / 180.0));
  }

  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ * (180.0 / std::numbers::pi); }

  /// The same direction in (−π, π].
  Angle wrapped() const {
    if (std::abs(radians_) < std::numbers::pi) return *this;  // much quicker, and what comes of it
    const double r = std::remainder(radians_, 2.0 * std::numbers::pi);
    return Angle(r <= -std::numbers::pi ? std::numbers::pi : r);
  }

  constexpr friend Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  constexpr friend Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  constexpr friend Angle operator*(double s, Angle a) { return Angle(s * a.radians_); }
  constexpr friend bool operator==(Angle, Angle) = default;

 private:
  constexpr explicit Angle(double radians) : radians_(radians) {}
  double radians_ = 0.0;
};

/// Unit vector of a direction in degrees, exact at the multiples of 90°: a ray at heading 90° runs
/// along +y and nothing else.
inline Point unit_vector_deg(double degrees) {
  int quotient = 0;
  const double rest = std::remquo(degrees, 90.0, &quotient) * (std::numbers::pi / 180.0);
  const double c = std::cos(rest);
  const double s = std::sin(rest);
  switch (static_cast<unsigned>(quotient) & 3U) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
  }
}

inline Point unit_vector(Angle direction) {
  return {std::cos(direction.radians()), std::sin(direction.radians())};
}

/// Position (metres, map frame) and heading of a robot.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  Angle theta;

  constexpr Point position() const { return {x, y}; }
  friend bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace mapwright
