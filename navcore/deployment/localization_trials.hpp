// Localization runs all over a map: does the robot find its place from its scans?
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/map.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localization/experiment.hpp"

namespace mapwright::navcore {

/// A run that ended with the robot not knowing where it is, or believing to be elsewhere.
struct LostRun {
  Pose start;                     ///< true pose where it began
  double position_error_m = 0.0;  ///< at its end
};

struct LocalizationTrials {
  std::size_t trials = 0;  ///< 0 where the robot fits nowhere
  std::size_t converged = 0;
  double median_error_m = 0.0;  ///< of the position at the end, all runs
  double p95_error_m = 0.0;     ///< 95 of 100 runs ended nearer (nearest rank)
  std::vector<LostRun> lost;
};

/// Global localization from random places by the report's experiment (section 4.1, figure 5), run i
/// with the seed `seed` + i. The outcome does not depend on the number of threads (0: one a core).
LocalizationTrials run_localization_trials(const Map& map, const FreeSpace& space,
                                           const ExperimentSettings& settings, std::size_t trials,
                                           std::uint64_t seed, unsigned threads);

}  // namespace mapwright::navcore
