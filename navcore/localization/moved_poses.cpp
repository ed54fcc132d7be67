#include "navcore/localization/moved_poses.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace mapwright::navcore {
namespace {

// A step without errors still has a density.
constexpr double kLeast_m = 0.002;
constexpr double kLeast_rad = 0.001;

// Between the poses that stand for what was known there are others: each is blurred by this share
// of the spread of all.
constexpr double kSmoothing = 0.4;

// So many poses stand for all: fewer where errors blur them more than they are spread.
constexpr std::size_t kLeastOrigins = 16;
constexpr std::size_t kMostOrigins = 128;

// Of a mixture's density, what is less than exp(this) of the greatest part counts as nothing.
constexpr double kNegligible = -12.0;

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

double squared_distance(const Vector& a, const Vector& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], turn = a[2] - b[2];
  return x * x + y * y + turn * turn;
}

// Of x, y and heading.
Matrix error_covariance(const OdometryStep& step, const OdometryNoise& noise, Angle course) {
  const StepErrors errors = step_errors(step, noise);
  const double c = std::cos(course.radians()), s = std::sin(course.radians());
  const double swing_m = step.distance_m * errors.turn_before_rad;
  const std::array<Vector, 3> effects{// where each error leads
                                      Vector{c * errors.distance_m, s * errors.distance_m, 0.0},
                                      Vector{-s * swing_m, c * swing_m, errors.turn_before_rad},
                                      Vector{0.0, 0.0, errors.turn_after_rad}};
  Matrix sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double least = i < 2 ? kLeast_m : kLeast_rad;
    sum[i][i] = least * least;
    for (std::size_t j = 0; j < 3; ++j) {
      for (const Vector& effect : effects) sum[i][j] += effect[i] * effect[j];
    }
  }
  return sum;
}

Matrix covariance_of(const std::vector<Vector>& points, const std::vector<double>& weights) {
  Vector mean{};
  Matrix sum{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += weights[k] * points[k][i];
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        sum[i][j] += weights[k] * (points[k][i] - mean[i]) * (points[k][j] - mean[j]);
      }
    }
  }
  return sum;
}

// The inverse of the Cholesky factor. Requires a positive definite matrix.
Matrix whitening_of(const Matrix& covariance) {
  Matrix factor{}, inverse{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      double value = covariance[r][c];
      for (std::size_t k = 0; k < c; ++k) value -= factor[r][k] * factor[c][k];
      factor[r][c] = r == c ? std::sqrt(value) : value / factor[c][c];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t r = c; r < 3; ++r) {
      double value = r == c ? 1.0 : 0.0;
      for (std::size_t k = c; k < r; ++k) value -= factor[r][k] * inverse[k][c];
      inverse[r][c] = value / factor[r][r];
    }
  }
  return inverse;
}

}  // namespace

MovedPoses::MovedPoses(const ParticleSet& from, const OdometryStep& step,
                       const OdometryNoise& noise)
    : centre_(moved(from.poses.front(), step)) {
  assert(from.size() > 0);
  std::vector<Vector> led;
  for (const Pose& pose : from.poses) led.push_back(off(moved(pose, step)));
  Matrix covariance = error_covariance(step, noise, centre_.theta - step.turn_after);
  const Matrix spread = covariance_of(led, from.weights);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      covariance[i][j] += kSmoothing * kSmoothing * spread[i][j];
    }
  }
  whitening_ = whitening_of(covariance);
  for (Vector& vector : led) vector = white(vector);
  choose(from, led);
}

// `led`: where the step leads them, whitened.
void MovedPoses::choose(const ParticleSet& from, const std::vector<Vector>& led) {
  const Matrix spread = covariance_of(led, from.weights);
  const double variance = spread[0][0] + spread[1][1] + spread[2][2];
  const auto wanted = static_cast<std::size_t>(variance * static_cast<double>(kMostOrigins));
  const std::size_t count = std::min(from.size(), std::clamp(wanted, kLeastOrigins, kMostOrigins));
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = k * from.size() / count;
    origins_.push_back(from.poses[i]);
    means_.push_back(led[i]);
    log_weights_.push_back(std::log(from.weights[i]));
    sum += from.weights[i];
  }
  log_normaliser_ = -1.5 * std::log(2.0 * std::numbers::pi) +
                    std::log(whitening_[0][0] * whitening_[1][1] * whitening_[2][2] / sum);
}

MovedPoses::Vector MovedPoses::off(const Pose& pose) const {
  double turn = (pose.theta - centre_.theta).radians();
  if (std::abs(turn) > std::numbers::pi) turn = Angle::from_radians(turn).wrapped().radians();
  return {pose.x - centre_.x, pose.y - centre_.y, turn};
}

MovedPoses::Vector MovedPoses::white(const Vector& off) const {
  return {whitening_[0][0] * off[0], whitening_[1][0] * off[0] + whitening_[1][1] * off[1],
          whitening_[2][0] * off[0] + whitening_[2][1] * off[1] + whitening_[2][2] * off[2]};
}

double MovedPoses::log_density(const Pose& pose) const {
  const Vector at = white(off(pose));
  std::array<double, kMostOrigins> logs;
  double greatest = -HUGE_VAL;
  for (std::size_t i = 0; i < means_.size(); ++i) {
    logs[i] = log_weights_[i] - 0.5 * squared_distance(at, means_[i]);
    greatest = std::max(greatest, logs[i]);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < means_.size(); ++i) {
    const double log = logs[i] - greatest;
    if (log > kNegligible) sum += std::exp(static_cast<float>(log));
  }
  return log_normaliser_ + greatest + std::log(sum);
}

const Pose& MovedPoses::origin_of(const Pose& pose) const {
  const Vector at = white(off(pose));
  const auto nearest =
      std::min_element(means_.begin(), means_.end(), [&](const Vector& a, const Vector& b) {
        return squared_distance(at, a) < squared_distance(at, b);
      });
  return origins_[static_cast<std::size_t>(nearest - means_.begin())];
}

}  // namespace mapwright::navcore
