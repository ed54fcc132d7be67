// A simulated laser: what the map gives, as a real scanner would report it.
#pragma once

#include <span>
#include <vector>

#include "mapcore/random.hpp"
#include "navcore/rays/laser.hpp"

namespace mapwright::navcore {

struct LaserNoise {
  double sigma_m = 0.05;   ///< σL: standard deviation of a range
  double occlusion = 0.0;  ///< probability that people or cars stop a beam early, in [0, 1]
};

/// Turns synthetic ranges into perceived ones. An occluded beam ends anywhere on its way with equal
/// probability. Then each echo gets Gaussian noise, clamped to [0, max_range_m]; a beam without
/// echo (RMAX) has nothing to be wrong about and stays. Draws the same number of random numbers
/// whatever the ranges are.
void add_noise(std::span<double> ranges, const LaserModel& laser, const LaserNoise& noise,
               Random& random);

/// A noisy scan from `pose`.
std::vector<double> perceive(const RayCaster& caster, const Pose& pose, const LaserModel& laser,
                             const LaserNoise& noise, Random& random);

}  // namespace mapwright::navcore
