// The report's planning experiment (section 4.2, figures 7 and 8) over many pairs: RRT beside
// balanced RRT, iterations and times, paths before and after smoothing.
//
// planning_experiment MAP.txt [RADIUS_M [PAIRS]]: a robot of that radius (default 0, the report's
// point), random pairs of places that are proved to be connected (default 30). Processor time of
// one thread.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bench/support/machine.hpp"
#include "bench/support/timing.hpp"
#include "mapcore/text/reader.hpp"
#include "navcore/planning/path.hpp"
#include "navcore/planning/planner.hpp"
#include "navcore/planning/smoothing.hpp"
#include "navcore/reachability/reachability_map.hpp"

namespace mapwright::bench {
namespace {

using namespace navcore;

struct Contender {
  const char* name;
  PlanningResult (*plan)(const FreeSpace&, const PlanQuery&, const RrtOptions&, Random&);
};

constexpr Contender kContenders[] = {{"rrt", &plan_rrt}, {"balanced-rrt", &plan_balanced_rrt}};

// Pairs of places proved to be connected, at least a tenth of the map apart.
std::vector<PlanQuery> draw_pairs(const FreeSpace& space, double radius_m, std::size_t count) {
  ReachabilityOptions options;
  options.radius_m = radius_m;
  const ReachabilityMap reachability(space, options);
  const Box box = space.border().box();
  const double least_m = 0.1 * std::max(box.width(), box.height());
  std::vector<PlanQuery> pairs;
  for (std::uint64_t i = 0; pairs.size() < count && i < 1000 * count; ++i) {
    Random random(2007, i);
    const auto start = space.sample(random, radius_m);
    const auto goal = space.sample(random, radius_m);
    if (!start || !goal || distance(*start, *goal) < least_m) continue;
    if (reachability.connected(*start, *goal) != Connection::kYes) continue;
    pairs.push_back({*start, *goal, radius_m});
  }
  return pairs;
}

struct Spread {
  double median = 0.0, mean = 0.0, most = 0.0;
};

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  return {values[values.size() / 2], sum / static_cast<double>(values.size()), values.back()};
}

void measure(const FreeSpace& space, const std::vector<PlanQuery>& pairs, const Contender& one) {
  std::vector<double> iterations, times_ms, smoothing_ms, raw_m, smooth_m;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Random random(1, i);
    const double begin = processor_seconds();
    const PlanningResult result = one.plan(space, pairs[i], {}, random);
    const double planned = processor_seconds();
    iterations.push_back(static_cast<double>(result.iterations));
    times_ms.push_back(1e3 * (planned - begin));
    if (!result.solved) continue;
    const auto path = smooth_path(space, result.path, pairs[i].radius_m, {}, random);
    smoothing_ms.push_back(1e3 * (processor_seconds() - planned));
    raw_m.push_back(path_length_m(result.path));
    smooth_m.push_back(path_length_m(path));
  }
  const Spread n = spread_of(iterations), ms = spread_of(times_ms);
  std::printf(
      "| %s | %zu of %zu | %.0f / %.0f / %.0f | %.2f / %.2f / %.2f | %.2f | %.1f | %.1f |\n",
      one.name, raw_m.size(), pairs.size(), n.median, n.mean, n.most, ms.median, ms.mean, ms.most,
      spread_of(smoothing_ms).mean, spread_of(raw_m).mean, spread_of(smooth_m).mean);
}

int run(const std::string& path, double radius_m, std::size_t count) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
    return 3;
  }
  const MapDocument document = read_map(std::string(std::istreambuf_iterator<char>(in), {}));
  const FreeSpace space(document.map);
  const auto pairs = draw_pairs(space, radius_m, count);
  std::printf("%s%s, %zu segments, radius %g m, %zu pairs\n\n", machine_description().c_str(),
              path.c_str(), segment_count(document.map), radius_m, pairs.size());
  std::printf(
      "| planner | solved | iterations: median / mean / most | ms: median / mean / most | ms to "
      "smooth | mean length m | smoothed m |\n|---|---|---|---|---|---|---|\n");
  for (const auto& contender : kContenders) measure(space, pairs, contender);
  return 0;
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  const double radius_m = argc > 2 ? std::atof(argv[2]) : 0.0;
  const int pairs = argc > 3 ? std::atoi(argv[3]) : 30;
  if (argc < 2 || argc > 4 || radius_m < 0.0 || pairs <= 0) {
    std::fprintf(stderr, "usage: planning_experiment MAP.txt [RADIUS_M [PAIRS]]\n");
    return 2;
  }
  return mapwright::bench::run(argv[1], radius_m, static_cast<std::size_t>(pairs));
}
