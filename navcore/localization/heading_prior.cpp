#include "navcore/localization/heading_prior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::navcore {
namespace {

// A perfect compass still has a density.
constexpr double kLeastSigma_deg = 0.01;

}  // namespace

Angle draw_heading(const std::optional<HeadingPrior>& prior, Random& random) {
  if (!prior) return Angle::from_radians(random.uniform(-std::numbers::pi, std::numbers::pi));
  return (prior->heading + Angle::from_degrees(random.normal(0.0, prior->sigma_deg))).wrapped();
}

double log_density(const std::optional<HeadingPrior>& prior, Angle heading) {
  if (!prior) return -std::log(2.0 * std::numbers::pi);
  const double sigma = Angle::from_degrees(std::max(kLeastSigma_deg, prior->sigma_deg)).radians();
  const double off = (heading - prior->heading).wrapped().radians() / sigma;
  return -0.5 * off * off - std::log(sigma * std::sqrt(2.0 * std::numbers::pi));
}

HeadingPrior turned(const HeadingPrior& heading, const OdometryStep& step,
                    const OdometryNoise& noise) {
  const double before = noise.turn_per_turn * step.turn_before.wrapped().degrees();
  const double after = noise.turn_per_turn * step.turn_after.wrapped().degrees();
  const double way = Angle::from_radians(noise.turn_per_metre * step.distance_m).degrees();
  const double error = std::hypot(std::hypot(before, after), std::numbers::sqrt2 * way);
  return {heading.heading + step.turn_before + step.turn_after,
          std::hypot(heading.sigma_deg, error)};
}

}  // namespace mapwright::navcore
