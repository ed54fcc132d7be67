// A set of weighted poses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/random.hpp"

namespace mapwright::navcore {

/// Particles, component by component: poses[i] has weight weights[i]. The weights sum up to 1.
struct ParticleSet {
  std::vector<Pose> poses;
  std::vector<double> weights;

  std::size_t size() const { return poses.size(); }
};

/// Every particle with the same weight.
ParticleSet with_equal_weights(std::vector<Pose> poses);

/// Effective sample size 1 / Σ w²: how many equally weighted particles are worth as much.
double effective_size(std::span<const double> weights);

/// Multiplies the weights by exp(exponent × log_factors) and normalises. Computed relative to the
/// greatest factor, so that the best particles never underflow. Where no product is positive — the
/// scan is impossible at each particle — the weights stay as they were and the answer is false.
bool multiply_weights(std::vector<double>& weights, std::span<const double> log_factors,
                      double exponent = 1.0);

/// `count` indices drawn in proportion to the weights, in ascending order, by low-variance
/// (systematic) resampling: one random number, and particle i is drawn ⌊count·w⌋ or ⌈count·w⌉ times
/// (Thrun, Burgard, Fox, Probabilistic Robotics, 2005, table 4.4).
std::vector<std::uint32_t> low_variance_sample(std::span<const double> weights, std::size_t count,
                                               Random& random);

}  // namespace mapwright::navcore
