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

/// begin … end − 1.
struct IndexRange {
  std::uint32_t begin = 0, end = 0;
};

/// Particles chosen, with the weights they go on with.
struct Sample {
  std::vector<std::uint32_t> indices;  ///< into the set that was drawn from
  std::vector<double> weights;         ///< sum up to 1
  std::vector<IndexRange> kin;         ///< per drawn one: the positions of those of its cell
};

/// Low-variance sampling by weight alone; the drawn ones weigh the same. No kin.
Sample sample_by_weight(const ParticleSet& particles, std::size_t count, Random& random);

/// Low-variance sampling by place: the particles lie in cells of 1 m × 1 m × 20°, and a cell with
/// the share W of the weight is drawn from in proportion to W^power, a particle in it in proportion
/// to its weight; what is drawn then weighs W / W^power. So the set stands for the same
/// distribution, and cells of little weight do not die out (resampling by priority scores: Liu,
/// Chen, Logvinenko, A theoretical framework for sequential importance sampling with resampling,
/// 2001). Cells are drawn from in order of place, so that chance moves no weight between far places
/// beyond one particle's. power in (0, 1].
Sample sample_by_place(const ParticleSet& particles, std::size_t count, double power,
                       Random& random);

}  // namespace mapwright::navcore
