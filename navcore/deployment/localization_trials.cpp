#include "navcore/deployment/localization_trials.hpp"

#include <vector>

#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::navcore {

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
  const MedianAndP95 error_m = median_and_p95(errors_m).value_or(MedianAndP95{});
  result.median_error_m = error_m.median;
  result.p95_error_m = error_m.p95;
  return result;
}

}  // namespace mapwright::navcore
