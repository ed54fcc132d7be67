// A simulated compass.
#pragma once

#include "mapcore/angle.hpp"
#include "mapcore/random.hpp"

namespace mapwright::navcore {

/// Standard deviation of the report's compass, degrees (section 4.1).
inline constexpr double kCompassError_deg = 3.0;

/// A reading with Gaussian error, in (−π, π].
inline Angle read_compass(Angle heading, double sigma_deg, Random& random) {
  return (heading + Angle::from_degrees(random.normal(0.0, sigma_deg))).wrapped();
}

}  // namespace mapwright::navcore
