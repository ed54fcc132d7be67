#include "navcore/localization/pose_belief.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace mapwright::navcore {
namespace {

constexpr double kTail = PoseBelief::kTail;
constexpr double kTailWidth = PoseBelief::kTailWidth;

constexpr double square(double x) {
  return x * x;
}

// Of a wrapped angle and a turn of less than a whole one; quicker than Angle::wrapped.
Angle wrapped(Angle angle) {
  const double a = angle.radians();
  if (std::abs(a) <= std::numbers::pi) return angle;
  return angle.wrapped();
}

// log((1 − t) exp(−d²/2) + t/27 exp(−d²/18)), relative to the latter.
double log_density_at(double squared) {
  const double inner = -0.5 * squared;
  const double outer = inner / square(kTailWidth);
  const double wide = kTail / (kTailWidth * square(kTailWidth));
  return outer + std::log((1.0 - kTail) * std::exp(inner - outer) + wide);
}

}  // namespace

PoseBelief::PoseBelief(const ParticleSet& particles, double sigma_m, double sigma_deg) {
  assert(particles.size() > 0 && sigma_m > 0.0 && sigma_deg > 0.0);
  const auto heaviest = std::max_element(particles.weights.begin(), particles.weights.end());
  const Pose centre =
      particles.poses[static_cast<std::size_t>(heaviest - particles.weights.begin())];
  Vector sum{};
  std::array<Vector, 3> squares{};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose& pose = particles.poses[i];
    const Vector off{pose.x - centre.x, pose.y - centre.y,
                     wrapped(pose.theta - centre.theta).radians()};
    for (std::size_t r = 0; r < 3; ++r) {
      sum[r] += particles.weights[i] * off[r];
      for (std::size_t c = 0; c <= r; ++c) squares[r][c] += particles.weights[i] * off[r] * off[c];
    }
  }
  mean_ = {centre.x + sum[0], centre.y + sum[1],
           wrapped(centre.theta + Angle::from_radians(sum[2]))};
  const double sigma_rad = Angle::from_degrees(sigma_deg).radians();
  const Vector least{square(sigma_m), square(sigma_m), square(sigma_rad)};
  const double share = 1.0 / (1.0 - kTail + kTail * square(kTailWidth));  // the tail has the rest
  for (std::size_t r = 0; r < 3; ++r) {                                   // Cholesky
    for (std::size_t c = 0; c <= r; ++c) {
      double value = share * (squares[r][c] - sum[r] * sum[c]) + (r == c ? least[r] : 0.0);
      for (std::size_t k = 0; k < c; ++k) value -= factor_[r][k] * factor_[c][k];
      // Rounding takes less from a diagonal than was added to it.
      factor_[r][c] = r == c ? std::sqrt(std::max(value, 0.5 * least[r])) : value / factor_[c][c];
    }
  }
}

PoseBelief::Deviate PoseBelief::deviate(Random& random) {
  const double width = random.uniform() < kTail ? kTailWidth : 1.0;
  Deviate deviate;
  double squared = 0.0;
  for (double& value : deviate.z) {
    value = width * random.normal();
    squared += square(value);
  }
  deviate.log_density = log_density_at(squared);
  return deviate;
}

Pose PoseBelief::at(const Deviate& deviate) const {
  Vector off{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c <= r; ++c) off[r] += factor_[r][c] * deviate.z[c];
  }
  return {mean_.x + off[0], mean_.y + off[1], wrapped(mean_.theta + Angle::from_radians(off[2]))};
}

double PoseBelief::log_normaliser() const {
  const double volume = factor_[0][0] * factor_[1][1] * factor_[2][2];
  return -1.5 * std::log(2.0 * std::numbers::pi) - std::log(volume);
}

double PoseBelief::log_density(const Pose& pose) const {
  const Vector off{pose.x - mean_.x, pose.y - mean_.y, wrapped(pose.theta - mean_.theta).radians()};
  Vector z{};
  double squared = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    double value = off[r];
    for (std::size_t c = 0; c < r; ++c) value -= factor_[r][c] * z[c];
    z[r] = value / factor_[r][r];
    squared += square(z[r]);
  }
  return log_density_at(squared);
}

}  // namespace mapwright::navcore
