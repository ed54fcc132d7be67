#include "navcore/localization/particles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "navcore/localization/place_cells.hpp"

namespace mapwright::navcore {
namespace {

void normalise(std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= sum;
}

}  // namespace

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

Sample sample_by_weight(const ParticleSet& particles, std::size_t count, Random& random) {
  return {low_variance_sample(particles.weights, count, random),
          std::vector<double>(count, 1.0 / static_cast<double>(count)),
          {}};
}

Sample sample_by_place(const ParticleSet& particles, std::size_t count, double power,
                       Random& random) {
  const CellOrder cells = sorted_into_cells(particles.poses);
  std::vector<double> priorities(particles.size());  // in order of place
  std::vector<double> corrections(particles.size());
  std::vector<std::uint32_t> cell_of_place(particles.size());
  for (std::size_t cell = 0; cell + 1 < cells.begins.size(); ++cell) {
    double weight = 0.0;
    for (std::size_t k = cells.begins[cell]; k < cells.begins[cell + 1]; ++k) {
      weight += particles.weights[cells.order[k]];
    }
    const double correction = weight > 0.0 ? std::pow(weight, 1.0 - power) : 1.0;
    for (std::size_t k = cells.begins[cell]; k < cells.begins[cell + 1]; ++k) {
      priorities[k] = particles.weights[cells.order[k]] / correction;
      corrections[k] = correction;
      cell_of_place[k] = static_cast<std::uint32_t>(cell);
    }
  }
  normalise(priorities);
  const auto drawn = low_variance_sample(priorities, count, random);
  Sample sample;
  for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
    while (end < count && cell_of_place[drawn[end]] == cell_of_place[drawn[begin]]) ++end;
    for (std::uint32_t i = begin; i < end; ++i) {
      sample.indices.push_back(cells.order[drawn[i]]);
      sample.weights.push_back(corrections[drawn[i]]);
      sample.kin.push_back({begin, end});
    }
  }
  normalise(sample.weights);
  return sample;
}

}  // namespace mapwright::navcore
