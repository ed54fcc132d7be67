#include "navcore/localization/particles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace mapwright::navcore {

ParticleSet with_equal_weights(std::vector<Pose> poses) {
  const double weight = 1.0 / static_cast<double>(poses.size());
  std::vector<double> weights(poses.size(), weight);
  return {std::move(poses), std::move(weights)};
}

double effective_size(std::span<const double> weights) {
  double squares = 0.0;
  for (const double w : weights) squares += w * w;
  return squares > 0.0 ? 1.0 / squares : 0.0;
}

bool multiply_weights(std::vector<double>& weights, std::span<const double> log_factors,
                      double exponent) {
  assert(weights.size() == log_factors.size());
  double greatest = -HUGE_VAL;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0) greatest = std::max(greatest, log_factors[i]);
  }
  if (greatest == -HUGE_VAL) return false;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] *= std::exp(exponent * (log_factors[i] - greatest));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= sum;
  return true;
}

std::vector<std::uint32_t> low_variance_sample(std::span<const double> weights, std::size_t count,
                                               Random& random) {
  assert(!weights.empty() && count > 0);
  std::vector<std::uint32_t> drawn(count);
  const double step = 1.0 / static_cast<double>(count);
  const double start = random.uniform() * step;
  double reached = weights[0];
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double target = start + static_cast<double>(k) * step;
    while (reached <= target && i + 1 < weights.size()) reached += weights[++i];
    drawn[k] = static_cast<std::uint32_t>(i);
  }
  return drawn;
}

}  // namespace mapwright::navcore
