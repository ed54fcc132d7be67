// What one beam can tell, by the noise of the laser.
#pragma once

#include <vector>

#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::navcore {

/// The distribution of one measured range, as Eq. (5) of the report has it: normal with σL about
/// the range that the map gives, or, with the probability of an occlusion (people, cars, what the
/// map lacks), uniform over 0 … RMAX.
///
///     f(z | r) = (1 − p) N(z; r, σL) + p / RMAX
///
/// Clipping at 0 and RMAX is neglected.
class BeamNoise {
 public:
  /// Requires σL > 0, 0 <= occlusion < 1, RMAX > 0.
  BeamNoise(const LaserNoise& noise, double max_range_m);

  /// Fisher information ∫ (∂f/∂r)² / f dz of one range about r, 1/m²: 1/σL² without occlusion.
  double information_per_m2() const { return information_per_m2_; }

  /// −ln of the Bhattacharyya coefficient ∫ √(f(z | r) f(z | r + Δ)) dz: how well one reading tells
  /// two ranges apart. Δ²/(8 σL²) without occlusion, and at most kMostNats; with it, it levels off.
  double distinction(double delta_m) const;

  /// The same for a beam that has an echo at one place and none at the other.
  double echo_distinction() const { return echo_distinction_; }

  double sigma_m() const { return noise_.sigma_m; }
  double occlusion() const { return noise_.occlusion; }

  /// What one beam can tell at most: a probability of e^−100 is none.
  static constexpr double kMostNats = 100.0;

 private:
  double density(double offset_m) const;

  LaserNoise noise_;
  double max_range_m_;
  double information_per_m2_ = 0.0;
  double echo_distinction_ = kMostNats;
  std::vector<double> table_;  ///< distinction at multiples of the step
};

/// Bounds on the smallest error probability with which two places, equally likely beforehand, can
/// be told apart by any rule, from their Bhattacharyya coefficient ρ (Kailath 1967):
/// (1 − √(1 − ρ²)) / 2 <= error <= ρ / 2.
struct ConfusionBounds {
  double least = 0.0;
  double most = 0.0;
};
ConfusionBounds confusion_bounds(double nats);

}  // namespace mapwright::navcore
