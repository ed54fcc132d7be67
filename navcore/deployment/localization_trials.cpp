#include "navcore/deployment/localization_trials.hpp"

#include <algorithm>
#include <cmath>

#include "navcore/engine/scan_engine.hpp"

namespace mapwright::navcore {
namespace {

// The value that `share` of the sorted values do not exceed (nearest rank).
double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

LocalizationTrials run_localization_trials(const Map& map, const FreeSpace& space,
                                           const ExperimentSettings& settings, std::size_t trials,
                                           std::uint64_t seed, unsigned threads) {
  const ScanEngine engine(map);
  const auto runs = run_trials(space, engine, engine, settings, trials, seed, threads);
  LocalizationTrials result;
  if (!runs) return result;  // no place to stand, which reachability tells better
  std::vector<double> errors_m;
  for (const auto& run : *runs) {
    ++result.trials;
    const double error_m = run.iterations.empty() ? 0.0 : run.iterations.back().position_error_m;
    errors_m.push_back(error_m);
    if (run.converged()) {
      ++result.converged;
    } else {
      result.lost.push_back({run.start, error_m});
    }
  }
  std::sort(errors_m.begin(), errors_m.end());
  result.median_error_m = quantile(errors_m, 0.5);
  result.p95_error_m = quantile(errors_m, 0.95);
  return result;
}

}  // namespace mapwright::navcore
