// The report's ray caster against every ray × every segment, on generated campuses: rays per
// second, and updates of all particles' weights per second.
//
// rays_bench: one thread, processor time, medians. 131 rays over 180°, RMAX 15 m, as in the report.
#include <cstdio>
#include <vector>

#include "bench/support/campus_generator.hpp"
#include "bench/support/machine.hpp"
#include "bench/support/timing.hpp"
#include "navcore/free_space.hpp"
#include "navcore/localization/particle_filter.hpp"
#include "navcore/rays/brute_force_ray_caster.hpp"
#include "navcore/rays/culled_ray_caster.hpp"

namespace mapwright::bench {
namespace {

constexpr int kRuns = 3;
constexpr std::size_t kParticles = 6000;  // the report's NP

std::vector<Pose> free_poses(const navcore::FreeSpace& space, std::size_t count) {
  Random random(1);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = space.sample(random).value();
    poses.push_back({p.x, p.y, Angle::from_degrees(random.uniform(-180.0, 180.0))});
  }
  return poses;
}

struct Speed {
  double rays_per_s = 0.0;
  double updates_per_s = 0.0;  ///< of kParticles particles, extrapolated from fewer
};

Speed measure(const navcore::RayCaster& caster, const std::vector<Pose>& poses) {
  const navcore::LaserModel laser;
  std::vector<double> ranges(poses.size() * laser.rays);
  const double cast_s = median_seconds(kRuns, [&] { caster.cast_all(poses, laser, ranges); });

  const navcore::RayCastingWeigher weigher(caster);
  const std::vector<double> scan(ranges.begin(), ranges.begin() + static_cast<long>(laser.rays));
  std::vector<double> factors(poses.size());
  const double weigh_s = median_seconds(
      kRuns, [&] { weigher.weigh(scan, laser, navcore::report_likelihood(), poses, factors, 1); });
  const double share = static_cast<double>(poses.size()) / static_cast<double>(kParticles);
  return {static_cast<double>(ranges.size()) / cast_s, share / weigh_s};
}

void compare(const char* name, const CampusOptions& options, std::size_t brute_poses,
             std::size_t culled_poses) {
  const Map map = generate_campus(options);
  const navcore::FreeSpace space(map);
  const Speed brute = measure(navcore::BruteForceRayCaster(map), free_poses(space, brute_poses));
  const Speed culled = measure(navcore::CulledRayCaster(map), free_poses(space, culled_poses));
  std::printf("%-6s %8zu segments  every segment %8.3f M rays/s %8.3f updates/s\n", name,
              segment_count(map), brute.rays_per_s * 1e-6, brute.updates_per_s);
  std::printf("%-6s %8s           culled        %8.3f M rays/s %8.3f updates/s  ratio %.1f, %.1f\n",
              "", "", culled.rays_per_s * 1e-6, culled.updates_per_s,
              culled.rays_per_s / brute.rays_per_s, culled.updates_per_s / brute.updates_per_s);
}

}  // namespace
}  // namespace mapwright::bench

int main() {
  using namespace mapwright::bench;
  std::printf("%s\n", machine_description().c_str());
  compare("100 m", kCampus100m, 300, 6000);
  compare("1 km", kCampus1km, 5, 3000);
}
