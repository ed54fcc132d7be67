// Whether the scans of a run tell the true place from the one that was taken for it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "navcore/localization/heading_prior.hpp"
#include "navcore/localization/scan_weigher.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// What a run has been through: scan i was taken at true pose i, which encoders say steps[i] led to
/// (the first step is not looked at).
struct Journey {
  std::vector<Pose> true_poses;
  std::vector<OdometryStep> steps;
  std::vector<std::vector<double>> scans;
  std::optional<HeadingPrior> compass;  ///< before the first scan
};

/// Where `pose` is taken by the rigid motion that takes `from` to `to`.
Pose carried_along(const Pose& pose, const Pose& from, const Pose& to);

/// The probability that the robot is right where it is (within `right_m` and `right_deg` of the
/// last true pose), after all scans, given that it began either near its true start or near the
/// start that the rigid motion from the last true pose to `estimate` takes it to, one as likely as
/// the other. What the filter did in between does not count. By the default filter's evidence
/// (robust_settings), with many particles at both places and nowhere else. Requires a non-empty
/// journey.
double evidence_for_truth(const ScanWeigher& weigher, const LaserModel& laser,
                          const OdometryNoise& odometry, const Journey& journey,
                          const Pose& estimate, double right_m, double right_deg,
                          std::uint64_t seed);

}  // namespace mapwright::navcore
