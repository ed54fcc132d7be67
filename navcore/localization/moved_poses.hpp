// What is known of a pose after a movement.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "navcore/localization/particles.hpp"
#include "navcore/sensors/odometry.hpp"

namespace mapwright::navcore {

/// The distribution of a pose that an odometry step has led to from one of some poses: the mixture,
/// over these, of where the step may have led from each (Klaas, de Freitas, Doucet, Toward
/// practical N² Monte Carlo: the marginal particle filter, 2005). No shape is imposed on what was
/// known before: along a wall that is a stretch with two ends, not a normal distribution. The
/// errors of the step (step_errors) are taken for normal in x, y and heading. To them comes a share
/// of the spread of all, so that few poses may stand for many (a regularised particle filter:
/// Musso, Oudjane, Le Gland, Improving regularised particle filters, 2001). A tenth of the
/// probability is spread three times as wide as all that (a defensive mixture: Hesterberg, Weighted
/// average importance sampling and defensive mixture distributions, 1995).
class MovedPoses {
 public:
  /// A pose before the step is one of `from`, by their weights. Requires at least one, and that
  /// they lie around one place. A step of no length and no turns leaves what was known as it was.
  MovedPoses(const ParticleSet& from, const OdometryStep& step, const OdometryNoise& noise);

  /// Logarithm of the probability a m² a radian.
  double log_density(const Pose& pose) const;

  /// The pose before the step that most likely led to `pose`.
  const Pose& origin_of(const Pose& pose) const;

 private:
  using Vector = std::array<double, 3>;  ///< x, y in metres, heading in radians
  using Matrix = std::array<Vector, 3>;

  Vector off(const Pose& pose) const;
  Vector white(const Vector& off) const;
  void choose(const ParticleSet& from, const std::vector<Vector>& led);
  void add_tail(const ParticleSet& from, const std::vector<Vector>& led);

  Pose centre_;         ///< the others are relative to it
  Matrix whitening_{};  ///< lower triangle: makes errors independent, of variance 1
  double log_normaliser_ = 0.0;
  std::vector<Pose> origins_;  ///< evenly chosen of all
  std::vector<Vector> means_;  ///< where the step leads them, whitened
  std::vector<double> log_weights_;

  // The tail's mean and spread, in terms of whitened poses.
  Vector tail_mean_{};
  Matrix tail_whitening_{};
  double log_tail_ = 0.0;
};

}  // namespace mapwright::navcore
