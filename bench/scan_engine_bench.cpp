// The scan engine on generated campuses, with its peers in the same run: rays per second, time of a
// whole particle filter update, memory, time to build.
//
// scan_engine_bench [100m] [1km] [10km]: these campuses (default: the first two). 131 rays over
// 180°, 15 m, 6000 poses, the same for all that are fast enough; one thread on one core, processor
// time: medians of interleaved rounds, of each the shortest runs.
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "bench/embree_rays.hpp"
#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/report_rays.hpp"
#include "mapcore/random.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/free_space.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace mapwright::bench {
namespace {

using navcore::LaserModel;
using navcore::LikelihoodKind;
using navcore::LikelihoodModel;
using navcore::ScanEngine;

constexpr std::size_t kPoses = 6000;
constexpr int kRounds = 9;
constexpr double kRoundSeconds = 0.03;  // of each contestant's turn in a round
constexpr double kRunSeconds = 0.002;   // of a run: the same for all, so that nobody's are spared
constexpr double kPassSeconds = 0.1;    // of a pass through all poses: who is slower gets fewer
constexpr int kLeastPasses = 3;         // in a round

// Processor time of this thread: other work on the machine does not count.
double seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& work) {
  const double start = seconds_now();
  work();
  return seconds_now() - start;
}

int pin_to_this_core() {
  const int core = sched_getcpu();
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(core, &set);
  pthread_setaffinity_np(pthread_self(), sizeof(set), &set);
  return core;
}

// -- poses ------------------------------------------------------------------------------------

std::vector<Pose> spread(const navcore::FreeSpace& space) {
  Random random(1);
  std::vector<Pose> poses;
  while (poses.size() < kPoses) {
    const Point p = space.sample(random).value();
    poses.push_back({p.x, p.y, Angle::from_degrees(random.uniform(-180.0, 180.0))});
  }
  return poses;
}

// Twelve robots that know where they are, 500 particles each.
std::vector<Pose> clustered(const navcore::FreeSpace& space) {
  constexpr std::size_t kRobots = 12;
  Random random(2);
  std::vector<Pose> poses;
  for (std::size_t robot = 0; robot < kRobots; ++robot) {
    const Point p = space.sample(random).value();
    const double heading = random.uniform(-180.0, 180.0);
    for (std::size_t i = 0; i < kPoses / kRobots; ++i) {
      poses.push_back({random.normal(p.x, 0.3), random.normal(p.y, 0.3),
                       Angle::from_degrees(random.normal(heading, 3.0))});
    }
  }
  return poses;
}

std::vector<Pose> every(std::size_t step, const std::vector<Pose>& poses) {
  std::vector<Pose> some;
  for (std::size_t i = 0; i < poses.size(); i += step) some.push_back(poses[i]);
  return some;
}

// -- contestants ------------------------------------------------------------------------------

struct Contestant {
  std::string name;
  std::function<void(std::span<const Pose>)> run;
  std::vector<Pose> poses = {};
  std::size_t poses_a_run = 0;
  std::vector<double> seconds = {};  ///< of the rounds

  double median_seconds_per_pose() {
    std::nth_element(seconds.begin(), seconds.begin() + kRounds / 2, seconds.end());
    return seconds[kRounds / 2] / static_cast<double>(poses.size());
  }
};

// Gives a contestant that is too slow for all poses fewer of them, evenly chosen, and sets how many
// it casts in a run.
void choose_poses(Contestant& contestant, const std::vector<Pose>& all) {
  const std::vector<Pose> few = every(kPoses / 12, all);
  contestant.run(few);  // warm
  // The least of several: one hiccup would leave a fast contestant with so few poses that all they
  // touch fits a cache.
  double least = seconds_of([&] { contestant.run(few); });
  for (int again = 0; again < 4; ++again) {
    least = std::min(least, seconds_of([&] { contestant.run(few); }));
  }
  const double seconds_per_pose = least / static_cast<double>(few.size());
  const double affordable = std::max(12.0, kPassSeconds / seconds_per_pose);
  const auto step = static_cast<std::size_t>(static_cast<double>(kPoses) / affordable);
  contestant.poses = every(std::max<std::size_t>(1, step), all);
  contestant.poses_a_run = static_cast<std::size_t>(std::max(1.0, kRunSeconds / seconds_per_pose));
  contestant.run(contestant.poses);
}

// Runs through all poses once; keeps the shortest time of each run in `least`. Returns what this
// pass took.
double pass(const Contestant& c, std::vector<double>& least) {
  double total = 0.0;
  for (std::size_t begin = 0, i = 0; begin < c.poses.size(); begin += c.poses_a_run, ++i) {
    const std::size_t count = std::min(c.poses_a_run, c.poses.size() - begin);
    const double seconds = seconds_of([&] { c.run({c.poses.data() + begin, count}); });
    if (i == least.size()) least.push_back(seconds);
    least[i] = std::min(least[i], seconds);
    total += seconds;
  }
  return total;
}

// In its turn a contestant runs for kRoundSeconds or more, so that caches and branch predictor are
// its own and not what others left behind. Of each run the shortest time counts: whatever else the
// machine does between, and with the caches, makes runs longer.
double seconds_in_turn(const Contestant& c) {
  c.run(c.poses);
  std::vector<double> least;
  double total = 0.0;
  for (int passes = 0; passes < kLeastPasses || total < kRoundSeconds; ++passes) {
    total += pass(c, least);
  }
  return std::accumulate(least.begin(), least.end(), 0.0);
}

void race(std::vector<Contestant>& contestants, const std::vector<Pose>& poses) {
  for (Contestant& contestant : contestants) choose_poses(contestant, poses);
  for (int round = 0; round < kRounds; ++round) {
    for (Contestant& c : contestants) c.seconds.push_back(seconds_in_turn(c));
  }
}

/// What is built for one campus.
struct Campus {
  explicit Campus(const CampusOptions& options) : map(generate_campus(options)) {
    engine_seconds = seconds_of([&] { engine = std::make_unique<ScanEngine>(map); });
    for (const auto name : ScanEngine::instruction_sets()) {
      if (name == engine->instruction_set()) continue;
      navcore::ScanEngineOptions other;
      other.instruction_set = std::string(name);
      others.push_back(std::make_unique<ScanEngine>(map, other));
    }
    culled_seconds = seconds_of([&] { culled = std::make_unique<navcore::CulledRayCaster>(map); });
    report = std::make_unique<ReportRays>(map);
    if (segment_count(map) < 10'000) brute = std::make_unique<navcore::BruteForceRayCaster>(map);
    if (EmbreeRays::is_available()) {
      embree_seconds =
          seconds_of([&] { embree = std::make_unique<EmbreeRays>(map, LaserModel{}.height_m); });
    }
    space = std::make_unique<navcore::FreeSpace>(map);
  }

  Map map;
  std::unique_ptr<ScanEngine> engine;
  std::vector<std::unique_ptr<ScanEngine>> others;  ///< other instruction sets
  std::unique_ptr<navcore::CulledRayCaster> culled;
  std::unique_ptr<ReportRays> report;
  std::unique_ptr<navcore::BruteForceRayCaster> brute;
  std::unique_ptr<EmbreeRays> embree;
  std::unique_ptr<navcore::FreeSpace> space;
  double engine_seconds = 0.0, culled_seconds = 0.0, embree_seconds = 0.0;
};

void print_building(const Campus& campus, double first_call_seconds) {
  const auto cells = campus.engine->cell_statistics(LaserModel{});
  constexpr double kMb = 1e6;
  std::printf(
      "  engine: built in %.3f s, %.1f MB; first cast of %zu spread poses %.1f ms "
      "(%zu cells, %.1f MB)\n",
      campus.engine_seconds, static_cast<double>(campus.engine->scene_bytes()) / kMb, kPoses,
      first_call_seconds * 1e3, cells.cells, static_cast<double>(cells.bytes) / kMb);
  std::printf("  CulledRayCaster: built in %.3f s\n", campus.culled_seconds);
  if (campus.embree) {
    std::printf("  Embree: built in %.3f s, %.1f MB\n", campus.embree_seconds,
                static_cast<double>(campus.embree->memory_bytes()) / kMb);
  }
}

std::vector<Contestant> casters(const Campus& campus, std::vector<float>& single,
                                std::vector<double>& twice) {
  const LaserModel laser;
  std::vector<Contestant> all;
  const auto engine = [&](const ScanEngine& e) {
    all.push_back({"engine, " + std::string(e.instruction_set()), [&, laser](auto poses) {
                     e.cast_all(poses, laser, {single.data(), poses.size() * laser.rays}, 1);
                   }});
  };
  const auto plain = [&](const char* name, const navcore::RayCaster& caster) {
    all.push_back({name, [&, laser](auto poses) {
                     caster.cast_all(poses, laser, {twice.data(), poses.size() * laser.rays});
                   }});
  };
  engine(*campus.engine);
  for (const auto& other : campus.others) engine(*other);
  if (campus.brute) plain("every ray x every segment", *campus.brute);
  plain("report, word for word", *campus.report);
  plain("CulledRayCaster", *campus.culled);
  if (!campus.embree) return all;
  for (const auto mode : EmbreeRays::kModes) {
    all.push_back(
        {"Embree, " + EmbreeRays::name(mode), [&, laser, mode](auto poses) {
           campus.embree->cast(mode, poses, laser, {single.data(), poses.size() * laser.rays});
         }});
  }
  return all;
}

// Ratios to the report's method as it is written and as it can be written, and to the best of
// Embree's modes.
void print_race(const char* name, std::vector<Contestant>& contestants) {
  const auto rate = [](Contestant& c) {
    return static_cast<double>(LaserModel{}.rays) / c.median_seconds_per_pose();
  };
  const auto best = [&](const char* prefix) {
    double most = 0.0;
    for (Contestant& c : contestants) {
      if (c.name.starts_with(prefix)) most = std::max(most, rate(c));
    }
    return most;
  };
  const double report = best("report"), culled = best("Culled"), embree = best("Embree");
  std::printf("  %-28s %10s %10s %10s %10s %10s\n", name, "M rays/s", "ns/scan", "x report",
              "x culled", "x Embree");
  for (Contestant& c : contestants) {
    std::printf("  %-28s %10.2f %10.1f %10.1f %10.1f", c.name.c_str(), rate(c) / 1e6,
                c.median_seconds_per_pose() * 1e9, rate(c) / report, rate(c) / culled);
    if (embree > 0.0) std::printf(" %10.2f", rate(c) / embree);
    std::printf("\n");
  }
}

void race_casters(const Campus& campus, const char* name, const std::vector<Pose>& poses) {
  std::vector<float> single(kPoses * LaserModel{}.rays);
  std::vector<double> twice(single.size());
  std::vector<Contestant> contestants = casters(campus, single, twice);
  race(contestants, poses);
  print_race(name, contestants);
}

// A whole update: ranges and weights of all particles.
void race_updates(const Campus& campus, const char* name, const std::vector<Pose>& poses) {
  const LaserModel laser;
  std::vector<double> scan(laser.rays), weights(kPoses);
  campus.culled->cast(poses.front(), laser, scan);
  const LikelihoodModel robust{LikelihoodKind::kRobust, 1.0, 1.0, 0.5, 0.1};
  std::vector<Contestant> contestants;
  const auto add = [&](const ScanEngine& e, const char* likelihood, const LikelihoodModel& model) {
    contestants.push_back(
        {std::string(likelihood) + ", " + std::string(e.instruction_set()), [&, model](auto p) {
           e.weigh(scan, laser, model, p, {weights.data(), p.size()}, 1);
         }});
  };
  const auto add_both = [&](const ScanEngine& e) {
    add(e, "Eq. (4)-(6)", navcore::report_likelihood());
    add(e, "robust likelihood", robust);
  };
  add_both(*campus.engine);
  for (const auto& other : campus.others) add_both(*other);
  race(contestants, poses);
  std::printf("  %-32s %10s\n", name, "ms");
  for (Contestant& c : contestants) {
    std::printf("  %-32s %10.3f\n", c.name.c_str(),
                c.median_seconds_per_pose() * static_cast<double>(kPoses) * 1e3);
  }
}

void run(const char* name, const CampusOptions& options) {
  const Campus campus(options);
  std::printf("\n%s: %zu segments\n", name, segment_count(campus.map));
  const std::vector<Pose> global = spread(*campus.space);
  const std::vector<Pose> tracking = clustered(*campus.space);
  std::vector<float> ranges(kPoses * LaserModel{}.rays);
  const double first =
      seconds_of([&] { campus.engine->cast_all(global, LaserModel{}, ranges, 1); });
  print_building(campus, first);
  race_casters(campus, "spread over the free space", global);
  race_casters(campus, "tracking", tracking);
  race_updates(campus, "update of 6000, spread", global);
  race_updates(campus, "update of 6000, tracking", tracking);
  std::fflush(stdout);
}

int main_of(const std::vector<std::string>& names) {
  const int core = pin_to_this_core();
  std::printf(
      "%spinned to core %d, processor time, medians of %d interleaved rounds of the shortest "
      "runs\n",
      machine_description().c_str(), core, kRounds);
  if (!EmbreeRays::is_available()) std::printf("built without Embree (libembree-dev)\n");
  for (const std::string& name : names) {
    if (name == "100m") run("100 m", kCampus100m);
    if (name == "1km") run("1 km", kCampus1km);
    if (name == "10km") run("10 km", kCampus10km);
  }
  return 0;
}

}  // namespace
}  // namespace mapwright::bench

int main(int count, char** arguments) {
  std::vector<std::string> names(arguments + 1, arguments + count);
  if (names.empty()) names = {"100m", "1km"};
  return mapwright::bench::main_of(names);
}
