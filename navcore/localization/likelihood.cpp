#include "navcore/localization/likelihood.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mapwright::navcore {
namespace {

// exp() of more than this overflows once 1/L of many beams is summed.
constexpr double kLargestExponent = 600.0;

// This many factors, each above 1e-9 and below 1e9, neither underflow nor overflow.
constexpr std::size_t kFactors = 32;

double peak_density(double sigma_m) {
  return 1.0 / (sigma_m * std::sqrt(2.0 * std::numbers::pi));
}

// −log Σ 1/L. Where Δ > 0, and for β = 0 everywhere, there is no uniform part and 1/L grows like
// exp(Δ²/2σ²): everything is divided by exp(shift) to keep the greatest term in range.
double log_harmonic(std::span<const double> perceived, std::span<const double> synthetic,
                    const LikelihoodModel& model, double max_range_m) {
  const bool two_sided = model.beta == 0.0;
  double longest = 0.0;
  for (std::size_t j = 0; j < perceived.size(); ++j) {
    const double delta = perceived[j] - synthetic[j];
    longest = std::max(longest, two_sided ? std::abs(delta) : delta);
  }
  const double c = -0.5 / (model.sigma_m * model.sigma_m);
  const double peak = model.alpha * peak_density(model.sigma_m);
  const double uniform = model.beta / max_range_m;
  const double shift = std::max(0.0, -c * longest * longest - kLargestExponent);
  const double scale = std::exp(-shift);
  double sum = 0.0;
  for (std::size_t j = 0; j < perceived.size(); ++j) {
    const double delta = perceived[j] - synthetic[j];
    const double exponent = c * delta * delta;
    sum += delta > 0.0 || two_sided ? std::exp(-exponent - shift) / peak
                                    : scale / (peak * std::exp(exponent) + uniform);
  }
  return -std::log(sum) - shift;
}

double log_product(std::span<const double> perceived, std::span<const double> synthetic,
                   const LikelihoodModel& model, double max_range_m) {
  const double c = -0.5 / (model.sigma_m * model.sigma_m);
  const double peak = model.alpha * peak_density(model.sigma_m);
  const double shorter = model.beta / max_range_m;
  const double longer = model.gamma / max_range_m;
  double sum = 0.0;
  for (std::size_t first = 0; first < perceived.size(); first += kFactors) {
    const std::size_t last = std::min(perceived.size(), first + kFactors);
    double product = 1.0;
    for (std::size_t j = first; j < last; ++j) {
      const double delta = perceived[j] - synthetic[j];
      product *= peak * std::exp(c * delta * delta) + (delta > 0.0 ? longer : shorter);
    }
    sum += std::log(product);
  }
  return sum;
}

}  // namespace

double log_weight_factor(std::span<const double> perceived, std::span<const double> synthetic,
                         const LikelihoodModel& model, double max_range_m) {
  assert(perceived.size() == synthetic.size());
  assert(model.sigma_m > 0.0 && max_range_m > 0.0);
  return model.kind == LikelihoodKind::kReport
             ? log_harmonic(perceived, synthetic, model, max_range_m)
             : log_product(perceived, synthetic, model, max_range_m);
}

}  // namespace mapwright::navcore
