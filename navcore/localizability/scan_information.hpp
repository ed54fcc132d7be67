// What a scan can tell of the robot's pose at best: Fisher information and its bound.
#pragma once

#include <span>

#include "mapcore/angle.hpp"
#include "navcore/engine/gradient_caster.hpp"

namespace mapwright::navcore {

/// Fisher information about a pose: the symmetric matrix over x, y (metres, map frame) and θ
/// (radians). Informations of independent measurements add up.
struct PoseInformation {
  double xx = 0.0, xy = 0.0, yy = 0.0;  ///< 1/m²
  double xt = 0.0, yt = 0.0;            ///< 1/(m rad)
  double tt = 0.0;                      ///< 1/rad²

  PoseInformation& operator+=(const PoseInformation& other);

  /// Adds `per_m2` times the outer product of the gradient of a measured length.
  void add(double by_x, double by_y, double by_theta, double per_m2);
};

/// Fisher information of one range of a Gaussian laser about that range, 1/m²: 1/σL².
constexpr double gaussian_range_information(double sigma_m) {
  return 1.0 / (sigma_m * sigma_m);
}

/// Fisher information of a scan whose ranges have independent errors: Σ g gᵀ `per_m2` over the
/// beams with an echo, g = ∂r/∂(x, y, θ). A beam without echo tells nothing.
PoseInformation scan_information(std::span<const RangeGradient> scan, double per_m2);

/// The scan from `pose`.
PoseInformation scan_information(const GradientCaster& caster, const Pose& pose,
                                 const LaserModel& laser, double per_m2);

/// Cramér-Rao bound: standard deviations below which no unbiased estimator of the pose gets.
/// Infinite where the scan does not tell.
struct AccuracyBound {
  double major_m = 0.0;   ///< of the position in the direction known least
  double minor_m = 0.0;   ///< of the position across that
  Angle major_direction;  ///< in the map, in (−90°, 90°]
  double heading_rad = 0.0;

  /// Of the position in any direction.
  double along_m(Angle direction) const;
};

/// The bound on the position when the heading is unknown too (marginal over θ), and on the heading
/// when the position is unknown too. Directions in which the information is below 1e-10 of the
/// greatest count as not known at all: rounding, not walls, makes them.
AccuracyBound accuracy_bound(const PoseInformation& information);

}  // namespace mapwright::navcore
