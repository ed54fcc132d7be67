#include "navcore/localization/kld_sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace mapwright::navcore {

double kld_sample_size(std::size_t bins, const KldSettings& settings) {
  if (bins <= 1) return 1.0;
  const double freedom = static_cast<double>(bins - 1);
  const double a = 2.0 / (9.0 * freedom);
  const double root = 1.0 - a + std::sqrt(a) * settings.z;
  return freedom / (2.0 * settings.epsilon) * root * root * root;
}

std::size_t occupied_bins(std::span<const Pose> poses, const KldSettings& settings) {
  const auto bin = [](double value, double width) {
    return static_cast<std::int64_t>(std::floor(value / width));
  };
  std::vector<std::array<std::int64_t, 3>> bins;
  bins.reserve(poses.size());
  for (const Pose& pose : poses) {
    bins.push_back({bin(pose.x, settings.bin_m), bin(pose.y, settings.bin_m),
                    bin(pose.theta.wrapped().degrees(), settings.bin_deg)});
  }
  std::sort(bins.begin(), bins.end());
  return static_cast<std::size_t>(std::unique(bins.begin(), bins.end()) - bins.begin());
}

}  // namespace mapwright::navcore
