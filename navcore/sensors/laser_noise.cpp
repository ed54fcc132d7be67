#include "navcore/sensors/laser_noise.hpp"

#include <algorithm>

namespace mapwright::navcore {

void add_noise(std::span<double> ranges, const LaserModel& laser, const LaserNoise& noise,
               Random& random) {
  for (double& range : ranges) {
    const bool occluded = random.uniform() < noise.occlusion;
    const double share = random.uniform();
    const double error_m = random.normal(0.0, noise.sigma_m);
    if (occluded) range *= share;
    if (range < laser.max_range_m) range = std::clamp(range + error_m, 0.0, laser.max_range_m);
  }
}

std::vector<double> perceive(const RayCaster& caster, const Pose& pose, const LaserModel& laser,
                             const LaserNoise& noise, Random& random) {
  std::vector<double> ranges(laser.rays);
  caster.cast(pose, laser, ranges);
  add_noise(ranges, laser, noise, random);
  return ranges;
}

}  // namespace mapwright::navcore
