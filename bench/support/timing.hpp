// Times for benchmarks that compare peers in one run.
#pragma once

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

namespace mapwright::bench {

/// Processor time this program has used, seconds: unlike wall time, it does not count what else the
/// machine does.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Median processor time of `job(prepare())`, seconds; what `prepare` does is not counted. For work
/// on one thread.
template <class Prepare, class Job>
double median_seconds(int runs, Prepare&& prepare, Job&& job) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    auto input = prepare();
    const double start = processor_seconds();
    job(std::move(input));
    seconds.push_back(processor_seconds() - start);
  }
  std::nth_element(seconds.begin(), seconds.begin() + runs / 2, seconds.end());
  return seconds[static_cast<std::size_t>(runs) / 2];
}

/// Median processor time of `job()`, seconds.
template <class Job>
double median_seconds(int runs, Job&& job) {
  return median_seconds(
      runs, [] { return 0; }, [&](int) { job(); });
}

}  // namespace mapwright::bench
