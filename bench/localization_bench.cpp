// What a scan costs a particle filter of 20,000 particles and 61 beams, on one core: prediction,
// weights, resampling where the effective sample size asks for it, estimate.
//
// localization_bench: a robot tracked on generated campuses; processor time, medians over the
// scans. Recorded logs are measured by bench/recorded_logs.sh.
#include <cstdio>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/timing.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "navcore/localization/localizer.hpp"
#include "navcore/localization/roaming.hpp"
#include "navcore/localization/trial_summary.hpp"

namespace mapwright::bench {
namespace {

constexpr std::size_t kParticles = 20000;
constexpr std::size_t kBeams = 61;
constexpr int kScans = 40;

struct Costs {
  double scan_s = 0.0;   ///< all of it
  double weigh_s = 0.0;  ///< weighing alone
  int resampled = 0;     ///< scans, of kScans
};

navcore::FilterSettings settings() {
  navcore::FilterSettings settings = navcore::recorded_settings().filter;
  settings.particles = kParticles;
  settings.kld.reset();
  settings.sweeps = 0;
  settings.temper = 8.0 / static_cast<double>(kBeams);
  settings.elsewhere_particles = 0;
  return settings;
}

Costs measure(const Map& map) {
  const navcore::FreeSpace space(map);
  const navcore::ScanEngine engine(map);
  const navcore::LaserModel laser{kBeams, 180.0, 25.0, 0.5};
  Random random(1);
  const Point start = space.sample(random, 1.0).value();
  Pose pose{start.x, start.y, Angle()};
  navcore::ParticleFilter filter(engine, laser, settings(), 1);
  filter.start_at(pose, 0.5, 10.0);
  std::vector<double> scan(kBeams), factors(kParticles);
  Costs costs;
  std::vector<double> scans_s, weigh_s;
  for (int i = 0; i < kScans; ++i) {
    const navcore::OdometryStep step = navcore::stroll(space, pose, 0.5, 0.4, random);
    pose = navcore::moved(pose, step);
    engine.cast(pose, laser, scan);
    const double start_s = processor_seconds();
    filter.move(step);
    costs.resampled += filter.update(scan).resampled ? 1 : 0;
    filter.estimate();
    const double middle_s = processor_seconds();
    engine.weigh(scan, laser, settings().likelihood, filter.particles().poses, factors, 1);
    scans_s.push_back(middle_s - start_s);
    weigh_s.push_back(processor_seconds() - middle_s);
  }
  costs.scan_s = *navcore::quantile(scans_s, 0.5);
  costs.weigh_s = *navcore::quantile(weigh_s, 0.5);
  return costs;
}

void report(const char* name, const CampusOptions& options) {
  const Costs costs = measure(generate_campus(options));
  std::printf(
      "%-6s %8zu segments  %zu particles x %zu beams: %.2f ms a scan (asked: 11), weighing "
      "%.2f ms; resampled %d of %d\n",
      name, options.segments, kParticles, kBeams, 1e3 * costs.scan_s, 1e3 * costs.weigh_s,
      costs.resampled, kScans);
}

}  // namespace
}  // namespace mapwright::bench

int main() {
  using namespace mapwright::bench;
  std::printf("%s\n", machine_description().c_str());
  report("100 m", kCampus100m);
  report("1 km", kCampus1km);
}
