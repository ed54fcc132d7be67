// A normal distribution of poses, with a tail.
#pragma once

#include <array>

#include "mapcore/random.hpp"
#include "navcore/localization/particles.hpp"

namespace mapwright::navcore {

/// Where a robot is that has one place: x, y (metres) and heading (radians) together normal, but a
/// tenth of the probability is spread three times as wide (Tukey's contaminated normal), because
/// what is modelled is never all that happens. With that tail it has the covariance it was made of:
/// a scan that says nothing leaves it as wide as it was.
class PoseBelief {
 public:
  static constexpr double kTail = 0.1;       ///< share of the probability that is spread wider
  static constexpr double kTailWidth = 3.0;  ///< so many times

  /// Mean and covariance of particles that lie around one place; headings are taken relative to
  /// that of the heaviest particle. The variances are raised by the squares of the given standard
  /// deviations, above 0. Requires a non-empty set.
  PoseBelief(const ParticleSet& particles, double sigma_m, double sigma_deg);

  /// What is random of a draw, the same for every belief.
  struct Deviate {
    std::array<double, 3> z{};
    double log_density = 0.0;
  };
  static Deviate deviate(Random& random);

  /// The pose that a deviate stands for; log_density(it) is the deviate's.
  Pose at(const Deviate& deviate) const;

  /// Up to a constant, the same for all poses.
  double log_density(const Pose& pose) const;

  /// That constant: with it, log_density is the logarithm of a probability a m² a radian. Another
  /// for each belief: beliefs are weighed against each other with it.
  double log_normaliser() const;

 private:
  using Vector = std::array<double, 3>;

  Pose mean_;
  std::array<Vector, 3> factor_{};  ///< lower triangle of the covariance's Cholesky factor
};

}  // namespace mapwright::navcore
