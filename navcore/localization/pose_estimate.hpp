// What a set of particles says of the robot's pose.
#pragma once

#include "navcore/localization/particles.hpp"

namespace mapwright::navcore {

/// The pose where most of the weight gathers, and how sure that is.
struct PoseEstimate {
  Pose pose;                   ///< mean of the heaviest mode
  double mode_share = 0.0;     ///< weight of that mode, in [0, 1]
  double mode_spread_m = 0.0;  ///< root mean square distance of the mode's particles from `pose`
  Angle mode_heading_spread;   ///< root mean square difference of their headings
  double spread_m = 0.0;       ///< root mean square distance of all particles from `pose`
};

/// A mode is what lies within this distance and heading of its centre.
inline constexpr double kModeRadius_m = 1.0;
inline constexpr double kModeHeading_deg = 20.0;

/// Finds the heaviest mode. Several places may explain the scans; their mean explains nothing,
/// so the estimate is the mean of one mode and never of all. Requires a non-empty set.
PoseEstimate estimate_pose(const ParticleSet& particles);

/// Weight of the particles within `limit_m` and `limit_deg` of a pose, in [0, 1].
double share_within(const ParticleSet& particles, const Pose& pose, double limit_m,
                    double limit_deg);

/// Weight of the particles within kModeRadius_m and kModeHeading_deg of a pose, in [0, 1].
double share_around(const ParticleSet& particles, const Pose& pose);

}  // namespace mapwright::navcore
