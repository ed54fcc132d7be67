#include "navcore/localization/sequential_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mapwright::navcore {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix kIdentity{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
    }
  }
  return product;
}

Matrix operator+(Matrix a, const Matrix& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) a[i][j] += b[i][j];
  }
  return a;
}

Matrix transposed(const Matrix& a) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = a[j][i];
  }
  return result;
}

// Solves a X = b by elimination with pivots; a is regular.
Matrix solved(Matrix a, Matrix b) {
  for (std::size_t column = 0; column < 3; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < 3; ++i) {
      if (std::abs(a[i][column]) > std::abs(a[pivot][column])) pivot = i;
    }
    std::swap(a[column], a[pivot]);
    std::swap(b[column], b[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == column) continue;
      const double factor = a[i][column] / a[column][column];
      for (std::size_t j = 0; j < 3; ++j) {
        a[i][j] -= factor * a[column][j];
        b[i][j] -= factor * b[column][j];
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) b[i][j] /= a[i][i];
  }
  return b;
}

Matrix matrix_of(const PoseInformation& p) {
  return {{{p.xx, p.xy, p.xt}, {p.xy, p.yy, p.yt}, {p.xt, p.yt, p.tt}}};
}

// Rounding leaves a matrix symmetric only nearly.
PoseInformation information_of(const Matrix& m) {
  return {m[0][0],
          0.5 * (m[0][1] + m[1][0]),
          m[1][1],
          0.5 * (m[0][2] + m[2][0]),
          0.5 * (m[1][2] + m[2][1]),
          m[2][2]};
}

// Covariance of the movement's end by its own errors.
Matrix step_covariance(Point along, const OdometryStep& step, const StepErrors& errors) {
  const Point across{-along.y, along.x};
  const std::array<std::array<double, 3>, 3> effects{{
      {errors.turn_before_rad * step.distance_m * across.x,
       errors.turn_before_rad * step.distance_m * across.y, errors.turn_before_rad},
      {errors.distance_m * along.x, errors.distance_m * along.y, 0.0},
      {0.0, 0.0, errors.turn_after_rad},
  }};
  Matrix covariance{};
  for (const auto& effect : effects) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) covariance[i][j] += effect[i] * effect[j];
    }
  }
  return covariance;
}

// What is said to have no error at all has this one: informations are finite.
constexpr double kLeastSigma = 1e-9;

double per_variance(double sigma) {
  return 1.0 / std::pow(std::max(sigma, kLeastSigma), 2);
}

}  // namespace

void SequentialBound::move(const Pose& from, const OdometryStep& step, const OdometryNoise& noise) {
  const Point along = unit_vector(from.theta + step.turn_before);
  Matrix back = kIdentity;  // F⁻¹: a turn at the start swings the end around
  back[0][2] = step.distance_m * along.y;
  back[1][2] = -step.distance_m * along.x;
  const Matrix carried = transposed(back) * matrix_of(information_) * back;
  const Matrix errors = step_covariance(along, step, step_errors(step, noise));
  information_ = information_of(solved(kIdentity + carried * errors, carried));
}

PoseInformation start_information(const ExperimentSettings& settings) {
  PoseInformation start;
  if (settings.tracks()) {
    start.xx = start.yy = per_variance(settings.initial_sigma_m);
    start.tt = per_variance(Angle::from_degrees(settings.initial_sigma_deg).radians());
  } else if (settings.heading_known) {
    start.tt = per_variance(Angle::from_degrees(settings.compass_error_deg).radians());
  }
  return start;
}

std::vector<AccuracyBound> sequential_bounds(const GradientCaster& caster,
                                             const ExperimentSettings& settings,
                                             const ExperimentRun& run) {
  const double per_m2 =
      (1.0 - settings.laser_noise.occlusion) * per_variance(settings.laser_noise.sigma_m);
  SequentialBound bound(start_information(settings));
  std::vector<AccuracyBound> bounds;
  const Pose* last = nullptr;
  for (const auto& iteration : run.iterations) {
    if (last != nullptr) bound.move(*last, iteration.step, settings.filter.odometry);
    last = &iteration.true_pose;
    bound.look(scan_information(caster, *last, settings.laser, per_m2));
    bounds.push_back(accuracy_bound(bound.information()));
  }
  return bounds;
}

double position_bound_m(const AccuracyBound& bound) {
  return std::hypot(bound.major_m, bound.minor_m);
}

std::optional<BoundSummary> summarize_bounds(std::span<const ExperimentRun> runs,
                                             std::span<const std::vector<AccuracyBound>> bounds) {
  std::vector<double> errors_m;
  double squared_errors = 0.0, squared_bounds = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t n = 0; n < bounds[i].size(); ++n) {
      const double bound_m = position_bound_m(bounds[i][n]);
      if (!std::isfinite(bound_m)) continue;
      errors_m.push_back(runs[i].iterations[n].position_error_m);
      squared_errors += errors_m.back() * errors_m.back();
      squared_bounds += bound_m * bound_m;
    }
  }
  const auto error_m = median_and_p95(errors_m);
  if (!error_m) return std::nullopt;
  const auto count = static_cast<double>(errors_m.size());
  return BoundSummary{*error_m, std::sqrt(squared_errors / count),
                      std::sqrt(squared_bounds / count)};
}

}  // namespace mapwright::navcore
