#include "navcore/localization/bearable_weights.hpp"

#include "navcore/localization/particles.hpp"

namespace mapwright::navcore {
namespace {

constexpr double kLeastShare = 0.15;
constexpr int kBisections = 6;

bool is_bearable(std::span<const double> weights) {
  return effective_size(weights) / static_cast<double>(weights.size()) >= kLeastShare;
}

}  // namespace

std::vector<double> flattened_weights(std::span<const double> log_weights, double exponent) {
  std::vector<double> weights(log_weights.size(), 1.0 / static_cast<double>(log_weights.size()));
  multiply_weights(weights, log_weights, exponent);
  return weights;
}

std::vector<double> bearable_weights(std::span<const double> log_weights, double least_exponent) {
  std::vector<double> weights = flattened_weights(log_weights, 1.0);
  if (is_bearable(weights)) return weights;
  double low = least_exponent, high = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (is_bearable(flattened_weights(log_weights, middle)) ? low : high) = middle;
  }
  return flattened_weights(log_weights, low);
}

}  // namespace mapwright::navcore
