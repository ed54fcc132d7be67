#include "navcore/localization/moved_poses.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "navcore/localization/pose_belief.hpp"

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

// What a few poses say of all has gaps, and the robot may be in one: some of the probability is
// spread wider than the whole mixture, as it is where particles are drawn.
constexpr double kTail = PoseBelief::kTail;
constexpr double kTailWidth = PoseBelief::kTailWidth;

// Of a mixture's density, what is less than exp(this) of the greatest part counts as nothing.
constexpr double kNegligible = -12.0;

// Of the peak of a normal density in three dimensions, of variance 1.
const double kLogNormal = -1.5 * std::log(2.0 * std::numbers::pi);

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

// Of a lower triangle with a vector.
Vector product(const Matrix& m, const Vector& v) {
  return {m[0][0] * v[0], m[1][0] * v[0] + m[1][1] * v[1],
          m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2]};
}

// Logarithm of how much a whitening enlarges a volume.
double log_volume(const Matrix& whitening) {
  return std::log(whitening[0][0] * whitening[1][1] * whitening[2][2]);
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
  add_tail(from, led);
}

// `led`: where the step leads them, whitened.
void MovedPoses::add_tail(const ParticleSet& from, const std::vector<Vector>& led) {
  Matrix covariance = covariance_of(led, from.weights);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < led.size(); ++k) tail_mean_[i] += from.weights[k] * led[k][i];
    covariance[i][i] += 1.0;
    for (double& value : covariance[i]) value *= kTailWidth * kTailWidth;
  }
  tail_whitening_ = whitening_of(covariance);
  log_tail_ = kLogNormal + log_volume(whitening_) + log_volume(tail_whitening_) + std::log(kTail);
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
  log_normaliser_ = kLogNormal + log_volume(whitening_) + std::log((1.0 - kTail) / sum);
}

MovedPoses::Vector MovedPoses::off(const Pose& pose) const {
  double turn = (pose.theta - centre_.theta).radians();
  if (std::abs(turn) > std::numbers::pi) turn = Angle::from_radians(turn).wrapped().radians();
  return {pose.x - centre_.x, pose.y - centre_.y, turn};
}

MovedPoses::Vector MovedPoses::white(const Vector& off) const {
  return product(whitening_, off);
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
  const double mixture = log_normaliser_ + greatest + std::log(sum);
  const Vector off_tail{at[0] - tail_mean_[0], at[1] - tail_mean_[1], at[2] - tail_mean_[2]};
  const double tail = log_tail_ - 0.5 * squared_distance(product(tail_whitening_, off_tail), {});
  return std::max(mixture, tail) + std::log1p(std::exp(-std::abs(mixture - tail)));
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
