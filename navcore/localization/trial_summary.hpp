// Many localization runs in a few numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "navcore/localization/experiment.hpp"

namespace mapwright::navcore {

/// The value below which a share `q` in [0, 1] of the values lies, linear between neighbours;
/// nothing for no values.
std::optional<double> quantile(std::vector<double> values, double q);

struct MedianAndP95 {
  double median = 0.0;
  double p95 = 0.0;
};

std::optional<MedianAndP95> median_and_p95(const std::vector<double>& values);

struct TrialSummary {
  /// All runs after their n-th iteration.
  struct AfterIterations {
    std::size_t n = 0;
    std::size_t right = 0;           ///< runs whose estimate is right
    std::size_t right_position = 0;  ///< runs within kRight_m, whatever the heading
    MedianAndP95 position_error_m;
  };

  /// How far the filter is to be believed: all iterations of all runs in which at least this share
  /// of the weight, and less than the next line's, lay where the estimate would be called right
  /// (IterationRecord::claim).
  struct Reliability {
    double from_share = 0.0;
    std::size_t iterations = 0;
    double mean_share = 0.0;  ///< what the filter said
    std::size_t right = 0;    ///< how often the estimate was right
  };

  std::size_t trials = 0;
  std::size_t converged = 0;
  std::size_t mistaken = 0;
  std::size_t depleted = 0;    ///< wrong at the end, although the scans decide for the truth
  std::size_t alike = 0;       ///< wrong at the end, and the scans do not
  std::size_t sure = 0;        ///< iterations of all runs that believed to be converged …
  std::size_t sure_right = 0;  ///< … and were right
  std::vector<Reliability> reliability;
  std::optional<MedianAndP95> iterations_to_converge;  ///< of the runs that converged
  std::optional<MedianAndP95> position_error_m;        ///< of all runs, at the end
  std::vector<AfterIterations> after;                  ///< 1, 2, 4, … iterations, and all
};

TrialSummary summarize(std::span<const ExperimentRun> runs);

}  // namespace mapwright::navcore
