#include "navcore/localization/trial_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mapwright::navcore {
namespace {

// 1, 2, 4, … and the last one.
std::vector<std::size_t> milestones(std::size_t iterations) {
  std::vector<std::size_t> numbers;
  for (std::size_t n = 1; n < iterations; n *= 2) numbers.push_back(n);
  if (iterations > 0) numbers.push_back(iterations);
  return numbers;
}

TrialSummary::AfterIterations after(std::span<const ExperimentRun> runs, std::size_t n) {
  TrialSummary::AfterIterations result;
  result.n = n;
  std::vector<double> errors_m;
  for (const auto& run : runs) {
    const IterationRecord& iteration = run.iterations[n - 1];
    if (iteration.is_right()) ++result.right;
    if (iteration.position_error_m <= kRight_m) ++result.right_position;
    errors_m.push_back(iteration.position_error_m);
  }
  result.position_error_m = median_and_p95(errors_m).value_or(MedianAndP95{});
  return result;
}

constexpr std::array kShares{0.0, 0.5, 0.8, 0.95, 0.99};

std::vector<TrialSummary::Reliability> reliability(std::span<const ExperimentRun> runs) {
  std::vector<TrialSummary::Reliability> rows;
  for (const double share : kShares) rows.push_back({share, 0, 0.0, 0});
  for (const auto& run : runs) {
    for (const auto& iteration : run.iterations) {
      const double share = iteration.claim;
      const auto row = std::upper_bound(kShares.begin(), kShares.end(), share) - kShares.begin();
      auto& reliability = rows[static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, row)) - 1];
      ++reliability.iterations;
      reliability.mean_share += share;
      reliability.right += iteration.is_right() ? 1 : 0;
    }
  }
  for (auto& row : rows) {
    if (row.iterations > 0) row.mean_share /= static_cast<double>(row.iterations);
  }
  return rows;
}

void count_beliefs(const ExperimentRun& run, TrialSummary& summary) {
  for (const auto& iteration : run.iterations) {
    if (!iteration.believes) continue;
    ++summary.sure;
    summary.sure_right += iteration.is_right() ? 1 : 0;
  }
}

}  // namespace

std::optional<double> quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double position = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(std::floor(position));
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (position - std::floor(position)) * (values[high] - values[low]);
}

std::optional<MedianAndP95> median_and_p95(const std::vector<double>& values) {
  const auto median = quantile(values, 0.5);
  if (!median) return std::nullopt;
  return MedianAndP95{*median, *quantile(values, 0.95)};
}

TrialSummary summarize(std::span<const ExperimentRun> runs) {
  TrialSummary summary;
  summary.trials = runs.size();
  std::vector<double> iterations, errors_m;
  for (const auto& run : runs) {
    if (run.mistaken()) ++summary.mistaken;
    count_beliefs(run, summary);
    if (!run.iterations.back().is_right()) {
      ++(run.lost() ? summary.depleted : summary.alike);
    }
    errors_m.push_back(run.iterations.back().position_error_m);
    if (!run.converged()) continue;
    ++summary.converged;
    iterations.push_back(static_cast<double>(run.right_from().value_or(run.iterations.size())));
  }
  summary.iterations_to_converge = median_and_p95(iterations);
  summary.position_error_m = median_and_p95(errors_m);
  summary.reliability = reliability(runs);
  if (runs.empty()) return summary;
  for (const std::size_t n : milestones(runs.front().iterations.size())) {
    summary.after.push_back(after(runs, n));
  }
  return summary;
}

}  // namespace mapwright::navcore
