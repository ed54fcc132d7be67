// Planners on generated campuses: time, iterations and length of the paths of the same pairs, ours
// and OMPL's RRTConnect beside them, in the same run.
//
// planning_bench [PAIRS]: that many random pairs a map (default 30), one thread, processor time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "bench/ompl_planner.hpp"
#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/timing.hpp"
#include "navcore/planning/path.hpp"
#include "navcore/planning/planner.hpp"
#include "navcore/planning/smoothing.hpp"
#include "navcore/reachability/reachability_map.hpp"

namespace mapwright::bench {
namespace {

using navcore::FreeSpace;
using navcore::PlanningResult;
using navcore::PlanQuery;
using navcore::RrtOptions;

using Planner = std::function<PlanningResult(const FreeSpace&, const PlanQuery&, Random&)>;

struct Contender {
  const char* name;
  Planner plan;
};

Planner ours(PlanningResult (*plan)(const FreeSpace&, const PlanQuery&, const RrtOptions&, Random&),
             double max_extension_m) {
  RrtOptions options;
  options.max_extension_m = max_extension_m;
  return [=](const FreeSpace& space, const PlanQuery& query, Random& random) {
    return plan(space, query, options, random);
  };
}

Planner smoothed(const Planner& plan) {
  return [=](const FreeSpace& space, const PlanQuery& query, Random& random) {
    PlanningResult result = plan(space, query, random);
    if (result.solved) {
      result.path = smooth_path(space, std::move(result.path), query.radius_m, {}, random);
    }
    return result;
  };
}

std::vector<Contender> contenders() {
  const Planner balanced = ours(&navcore::plan_balanced_rrt, 0.0);
  const Planner balanced_20 = ours(&navcore::plan_balanced_rrt, 20.0);
  std::vector<Contender> all{
      {"rrt", ours(&navcore::plan_rrt, 0.0)},
      {"balanced-rrt", balanced},
      {"balanced-rrt, smoothed", smoothed(balanced)},
      {"balanced-rrt, edges to 20 m", balanced_20},
      {"balanced-rrt, edges to 20 m, smoothed", smoothed(balanced_20)},
  };
  if (has_ompl()) {
    all.push_back({"OMPL RRTConnect, our exact check", &plan_with_ompl_exactly});
    all.push_back({"OMPL RRTConnect, checks every 0.1 m", &plan_with_ompl_in_steps});
  }
  return all;
}

std::vector<PlanQuery> draw_pairs(const FreeSpace& space, double radius_m, std::size_t count) {
  std::vector<PlanQuery> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(2007, i);
    const auto start = space.sample(random, radius_m);
    const auto goal = space.sample(random, radius_m);
    if (start && goal) pairs.push_back({*start, *goal, radius_m});
  }
  return pairs;
}

void measure(const FreeSpace& space, const std::vector<PlanQuery>& pairs, const Contender& one) {
  std::vector<double> times_s;
  std::size_t solved = 0;
  std::size_t collisions = 0;
  std::size_t iterations = 0;
  double length_m = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Random random(1, i);
    const double begin = processor_seconds();
    const PlanningResult result = one.plan(space, pairs[i], random);
    times_s.push_back(processor_seconds() - begin);
    iterations += result.iterations;
    if (!result.solved) continue;
    ++solved;
    length_m += navcore::path_length_m(result.path);
    collisions += is_free_path(space, result.path, pairs[i].radius_m) ? 0 : 1;
  }
  std::sort(times_s.begin(), times_s.end());
  double total_s = 0.0;
  for (const double time : times_s) total_s += time;
  const double count = static_cast<double>(pairs.size());
  std::printf("  %-38s %4zu %6zu %11.3f %11.3f %11.0f %12.0f\n", one.name, solved, collisions,
              1e3 * times_s[times_s.size() / 2], 1e3 * total_s / count,
              static_cast<double>(iterations) / count, length_m);
}

void measure_reachability(const FreeSpace& space, double radius_m) {
  navcore::ReachabilityOptions options;
  options.radius_m = radius_m;
  const double begin = processor_seconds();
  const navcore::ReachabilityMap reachability(space, options);
  std::printf("  reachability of all areas: %.0f ms, %zu cells, %zu areas\n",
              1e3 * (processor_seconds() - begin), reachability.cell_count(),
              reachability.areas().size());
}

void run(const CampusOptions& options, std::size_t pairs) {
  const Map map = generate_campus(options);
  const double begin = processor_seconds();
  const FreeSpace space(map);
  std::printf("\n%zu segments on %.0f m x %.0f m; free space built in %.1f ms\n", options.segments,
              options.side_m, options.side_m, 1e3 * (processor_seconds() - begin));
  for (const double radius_m : {0.0, 0.4}) {
    const auto queries = draw_pairs(space, radius_m, pairs);
    std::printf("\nradius %.1f m, %zu pairs\n", radius_m, queries.size());
    std::printf("  %-38s %4s %6s %11s %11s %11s %12s\n", "", "ok", "cut", "median ms", "mean ms",
                "iterations", "length m");
    for (const auto& contender : contenders()) measure(space, queries, contender);
    if (radius_m > 0.0) measure_reachability(space, radius_m);
  }
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  const int pairs = argc > 1 ? std::atoi(argv[1]) : 30;
  if (pairs <= 0) {
    std::fprintf(stderr, "usage: planning_bench [PAIRS]\n");
    return 2;
  }
  std::printf("%s", mapwright::bench::machine_description().c_str());
  std::printf("ok: pairs solved; cut: paths that our exact check rejects; length: of all paths\n");
  if (!mapwright::bench::has_ompl()) std::printf("built without OMPL (libompl-dev): no peer\n");
  for (const auto& campus : {mapwright::bench::kCampus100m, mapwright::bench::kCampus1km}) {
    mapwright::bench::run(campus, static_cast<std::size_t>(pairs));
  }
}
