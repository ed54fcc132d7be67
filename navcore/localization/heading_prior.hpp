// What is known of a heading beside the scans.
#pragma once

#include <optional>

#include "mapcore/angle.hpp"
#include "mapcore/random.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// A compass reading and its standard deviation.
struct HeadingPrior {
  Angle heading;
  double sigma_deg = 0.0;
};

/// From the reading's normal distribution; without one, from all headings alike.
Angle draw_heading(const std::optional<HeadingPrior>& prior, Random& random);

/// Logarithm of the probability a radian.
double log_density(const std::optional<HeadingPrior>& prior, Angle heading);

/// A compass reading carried along by what the encoders say.
HeadingPrior turned(const HeadingPrior& heading, const OdometryStep& step,
                    const OdometryNoise& noise);

}  // namespace mapwright::navcore
