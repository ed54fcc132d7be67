#include "navcore/localizability/beam_noise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mapwright::navcore {
namespace {

constexpr double kTails = 9.0;         // σ: beyond this a normal density is nothing
constexpr std::size_t kPerSigma = 16;  // steps of the table
constexpr double kTable = 14.0;        // σ: two peaks further apart have nothing in common

// Simpson's rule; steps is even.
template <class Function>
double integral(double from, double to, std::size_t steps, Function&& f) {
  const double h = (to - from) / static_cast<double>(steps);
  double sum = f(from) + f(to);
  for (std::size_t i = 1; i < steps; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) * f(from + h * static_cast<double>(i));
  }
  return sum * h / 3.0;
}

}  // namespace

BeamNoise::BeamNoise(const LaserNoise& noise, double max_range_m)
    : noise_(noise), max_range_m_(max_range_m) {
  assert(noise.sigma_m > 0.0 && max_range_m > 0.0);
  assert(noise.occlusion >= 0.0 && noise.occlusion < 1.0);
  const double sigma = noise_.sigma_m;
  const double tails = kTails * sigma;
  information_per_m2_ = integral(-tails, tails, 400, [&](double z) {
    const double slope = (density(z) - noise_.occlusion / max_range_m_) * z / (sigma * sigma);
    return slope == 0.0 ? 0.0 : slope * slope / density(z);
  });
  for (std::size_t i = 0; i <= kPerSigma * static_cast<std::size_t>(kTable); ++i) {
    const double delta = sigma * static_cast<double>(i) / kPerSigma;
    if (noise_.occlusion == 0.0) {
      table_.push_back(std::min(kMostNats, delta * delta / (8.0 * sigma * sigma)));
      continue;
    }
    const double peaks = integral(-tails, delta + tails, 800, [&](double z) {
      return std::sqrt(density(z) * density(z - delta));
    });
    const double rest = noise_.occlusion * (1.0 - (delta + 2.0 * tails) / max_range_m_);
    table_.push_back(-std::log(std::min(1.0, peaks + rest)));
  }
  table_.front() = 0.0;
  if (noise_.occlusion == 0.0) return;
  // No echo is one reading with the probability 1 − p; only occlusions are common to both.
  const double floor = noise_.occlusion / max_range_m_;
  const double common =
      integral(-tails, tails, 400, [&](double z) { return std::sqrt(floor * density(z)); });
  echo_distinction_ = -std::log(common + noise_.occlusion * (1.0 - 2.0 * tails / max_range_m_));
}

double BeamNoise::density(double offset_m) const {
  const double t = offset_m / noise_.sigma_m;
  const double peak = 1.0 / (noise_.sigma_m * std::sqrt(2.0 * std::numbers::pi));
  return (1.0 - noise_.occlusion) * peak * std::exp(-0.5 * t * t) + noise_.occlusion / max_range_m_;
}

double BeamNoise::distinction(double delta_m) const {
  const double t = std::abs(delta_m) / noise_.sigma_m;
  if (noise_.occlusion == 0.0) return std::min(kMostNats, t * t / 8.0);
  const double at = t * kPerSigma;
  const auto i = static_cast<std::size_t>(std::min(at, 1.0e9));
  if (i + 1 >= table_.size()) return table_.back();
  return table_[i] + (at - static_cast<double>(i)) * (table_[i + 1] - table_[i]);
}

ConfusionBounds confusion_bounds(double nats) {
  const double affinity = std::exp(-std::max(0.0, nats));
  const double square = affinity * affinity;
  // 1 − √(1 − ρ²), without cancellation.
  return {0.5 * square / (1.0 + std::sqrt(std::max(0.0, 1.0 - square))), 0.5 * affinity};
}

}  // namespace mapwright::navcore
