#include "navcore/engine/scan_weight.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace mapwright::navcore::engine {
namespace {

// Magnitude of the logarithm up to which single precision has room to spare (it ends at 87).
constexpr double kSafeLogarithm = 80.0;

double log_magnitude(double factor) {
  return factor > 0.0 ? std::abs(std::log(factor)) : 0.0;
}

}  // namespace

ScanWeight::ScanWeight(std::span<const double> ranges, const LaserModel& laser,
                       const LikelihoodModel& model)
    : kind(model.kind) {
  assert(ranges.size() == laser.rays && model.alpha > 0.0 && model.sigma_m > 0.0);
  const double gamma = kind == LikelihoodKind::kRobust ? model.gamma : 0.0;
  const double top = model.alpha / (model.sigma_m * std::sqrt(2.0 * std::numbers::pi));
  const double shorter = model.beta / laser.max_range_m;
  const double longer = gamma / laser.max_range_m;
  peak = static_cast<float>(top);
  log2_peak = static_cast<float>(std::log2(top));
  steepness = static_cast<float>(0.5 * std::numbers::log2e / (model.sigma_m * model.sigma_m));
  shorter_floor = static_cast<float>(shorter);
  longer_floor = static_cast<float>(longer);
  const double worst = std::max({log_magnitude(top), log_magnitude(shorter), log_magnitude(longer),
                                 log_magnitude(top + std::max(shorter, longer)), 1e-3});
  safe_factors = std::max<std::size_t>(1, static_cast<std::size_t>(kSafeLogarithm / worst));
  perceived.assign(padded_to_block(laser.rays), 0.0F);
  std::transform(ranges.begin(), ranges.end(), perceived.begin(),
                 [](double range) { return static_cast<float>(range); });
}

}  // namespace mapwright::navcore::engine
