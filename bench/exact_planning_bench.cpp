// The exact planner: what a map costs to prepare, and what a query costs beside OMPL's RRTConnect
// with our exact check of motions, for the same pairs in the same run.
//
// exact_planning_bench [WORLD...]: with worlds that have published lengths, also the time a query
// takes there: X.geojson beside X.queries.csv (polygons of free space, Euclidean optima), or X.map
// beside X.map.scen (grid, optima of straight and diagonal steps). One thread, processor time.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "bench/ompl_planner.hpp"
#include "bench/support/campus_generator.hpp"
#include "bench/support/grid_world.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/polygonal_world.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "navcore/planning/path.hpp"

namespace mapwright::bench {
namespace {

using navcore::ExactPlanner;
using navcore::ExactWorkspace;
using navcore::FreeSpace;
using navcore::PlanQuery;

constexpr std::size_t kPairs = 30;
constexpr int kRepetitions = 5;

double seconds_now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double begin = seconds_now();
  work();
  return seconds_now() - begin;
}

// Times of one contender, and what its paths add up to.
struct Score {
  std::vector<double> times_s;
  std::vector<double> lengths_m;

  double mean_s() const {
    return std::accumulate(times_s.begin(), times_s.end(), 0.0) /
           static_cast<double>(times_s.size());
  }
  double median_s() const {
    std::vector<double> sorted = times_s;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
  double length_m() const { return std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0); }
};

// Pairs of places between which the robot can travel.
std::vector<PlanQuery> draw_pairs(const Map& map, const ExactPlanner& planner, double radius_m) {
  Random random(2007);
  std::vector<PlanQuery> pairs;
  const Box box = map.border.box();
  const auto draw = [&] {
    return Point{random.uniform(box.min_x, box.max_x), random.uniform(box.min_y, box.max_y)};
  };
  while (pairs.size() < kPairs) {
    const Point start = draw(), goal = draw();
    if (planner.component_at(start) == 0U && planner.component_at(goal) == 0U) {
      pairs.push_back({start, goal, radius_m});
    }
  }
  return pairs;
}

Score run_exact(const ExactPlanner& planner, const std::vector<PlanQuery>& pairs) {
  Score score;
  ExactWorkspace workspace;
  for (const auto& pair : pairs) {
    for (int i = 0; i < kRepetitions; ++i) {
      navcore::ExactAnswer answer;
      score.times_s.push_back(
          seconds_of([&] { answer = planner.plan(pair.start, pair.goal, workspace); }));
      if (i == 0) score.lengths_m.push_back(answer.length_m);
    }
  }
  return score;
}

Score run_ompl(const FreeSpace& space, const std::vector<PlanQuery>& pairs) {
  Score score;
  for (const auto& pair : pairs) {
    for (int i = 0; i < kRepetitions; ++i) {
      Random unused(1);
      navcore::PlanningResult result;
      score.times_s.push_back(
          seconds_of([&] { result = plan_with_ompl_exactly(space, pair, unused); }));
      if (i == 0) score.lengths_m.push_back(navcore::path_length_m(result.path));
    }
  }
  return score;
}

void print(const char* name, const Score& score) {
  std::printf("  %-34s %12.1f %12.1f %12.0f\n", name, 1e6 * score.median_s(), 1e6 * score.mean_s(),
              score.length_m());
}

void compare(const Map& map, double radius_m) {
  const auto planner = ExactPlanner::build(map, {.radius_m = radius_m});
  const auto pairs = draw_pairs(map, *planner, radius_m);
  std::printf("\nradius %.1f m, %zu pairs, %d times each\n", radius_m, pairs.size(), kRepetitions);
  std::printf("  %-34s %12s %12s %12s\n", "", "median us", "mean us", "length m");
  const Score exact = run_exact(*planner, pairs);
  print("exact", exact);
  if (radius_m > 0.0) {
    const auto fine = ExactPlanner::build(map, {.radius_m = radius_m, .tangents_a_quadrant = 32});
    print("exact, 32 tangents a quadrant", run_exact(*fine, pairs));
  }
  if (!has_ompl()) return;
  const Score ompl = run_ompl(FreeSpace(map), pairs);
  print("OMPL RRTConnect, our exact check", ompl);
  std::size_t shorter = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    shorter += exact.lengths_m[i] <= ompl.lengths_m[i] + 1e-9 ? 1U : 0U;
  }
  std::printf("  mean %.1f times as fast, median %.1f times; path not longer for %zu of %zu\n",
              ompl.mean_s() / exact.mean_s(), ompl.median_s() / exact.median_s(), shorter,
              pairs.size());
}

void prepare(const Map& map) {
  const double count = static_cast<double>(segment_count(map));
  const auto build = [&](double radius_m) {
    return 1e6 / count * seconds_of([&] {
             const auto planner = ExactPlanner::build(map, {.radius_m = radius_m});
           });
  };
  const auto planner = ExactPlanner::build(map, {});
  const Point centre{0.5 * (map.border.left + map.border.right),
                     0.5 * (map.border.top + map.border.bottom)};
  const double widths_us = 1e6 / count * seconds_of([&] { planner->bottleneck(centre, centre); });
  std::printf("%9.0f %14.2f %14.2f %14.2f\n", count, build(0.0), build(0.4), widths_us);
}

struct World {
  Map map;
  std::vector<PublishedQuery> queries;
};

World read_world(const std::string& path) {
  std::ifstream world(path);
  if (path.ends_with(".map")) {
    std::ifstream scenarios(path + ".scen");
    return {read_grid_world(world), read_scenarios(scenarios)};
  }
  std::ifstream csv(path.substr(0, path.rfind('.')) + ".queries.csv");
  return {read_polygonal_world(world), read_published_queries(csv)};
}

void measure_world(const std::string& path) {
  const World world = read_world(path);
  const auto planner = ExactPlanner::build(world.map, {});
  Score score;
  ExactWorkspace workspace;
  double published_m = 0.0;
  std::size_t met = 0, longer = 0;
  for (const auto& query : world.queries) {
    navcore::ExactAnswer answer;
    score.times_s.push_back(
        seconds_of([&] { answer = planner->plan(query.start, query.goal, workspace); }));
    score.lengths_m.push_back(answer.length_m);
    published_m += query.optimum_m;
    met += std::abs(answer.length_m - query.optimum_m) <= 1e-4 * query.optimum_m ? 1U : 0U;
    longer += answer.path.empty() || answer.length_m > query.optimum_m * (1.0 + 1e-5) ? 1U : 0U;
  }
  const std::string name = path.substr(path.rfind('/') + 1);
  std::printf("%-22s %8zu %7zu %7zu %7zu %12.0f %12.0f %10.1f %10.1f\n", name.c_str(),
              segment_count(world.map), world.queries.size(), met, longer, published_m,
              score.length_m(), 1e6 * score.median_s(), 1e6 * score.mean_s());
}

void measure_worlds(int count, char** paths) {
  std::printf("\nworlds with published lengths (met: to 1e-4; longer: more than published)\n");
  std::printf("%-22s %8s %7s %7s %7s %12s %12s %10s %10s\n", "", "segments", "queries", "met",
              "longer", "published m", "ours m", "median us", "mean us");
  for (int i = 0; i < count; ++i) measure_world(paths[i]);
}

}  // namespace
}  // namespace mapwright::bench

int main(int argc, char** argv) {
  using namespace mapwright::bench;
  std::printf("%s", machine_description().c_str());
  if (!has_ompl()) std::printf("built without OMPL (libompl-dev): no peer\n");
  std::printf("\nto prepare, us a segment:\n%9s %14s %14s %14s\n", "segments", "point",
              "disc 0.4 m", "widths");
  for (const auto& campus : {kCampus100m, kCampus1km, CampusOptions{3100.0, 500'000, 1}}) {
    prepare(generate_campus(campus));
  }
  for (const auto& campus : {kCampus100m, kCampus1km}) {
    const auto map = generate_campus(campus);
    std::printf("\n%zu segments on %.0f m x %.0f m\n", campus.segments, campus.side_m,
                campus.side_m);
    for (const double radius_m : {0.0, 0.4}) compare(map, radius_m);
  }
  if (argc > 1) measure_worlds(argc - 1, argv + 1);
}
