#include "navcore/sensors/odometry.hpp"

#include <cmath>
#include <numbers>

namespace mapwright::navcore {
namespace {

constexpr double kDirectionMatters_m = 0.01;

double turn_size(Angle turn) {
  return std::abs(turn.wrapped().radians());
}

}  // namespace

OdometryStep step_between(const Pose& from, const Pose& to) {
  const Point way = to.position() - from.position();
  const double distance_m = length(way);
  const Angle turn = (to.theta - from.theta).wrapped();
  if (distance_m < kDirectionMatters_m) {
    return {Angle(), dot(way, unit_vector(from.theta)), turn};
  }
  Angle before = (Angle::from_radians(std::atan2(way.y, way.x)) - from.theta).wrapped();
  const bool backwards = std::abs(before.radians()) > std::numbers::pi / 2.0;
  if (backwards) before = (before + Angle::from_degrees(180.0)).wrapped();
  return {before, backwards ? -distance_m : distance_m, (turn - before).wrapped()};
}

Pose moved(const Pose& pose, const OdometryStep& step) {
  const Angle course = pose.theta + step.turn_before;
  const Point way = step.distance_m * unit_vector(course);
  return {pose.x + way.x, pose.y + way.y, (course + step.turn_after).wrapped()};
}

StepErrors step_errors(const OdometryStep& step, const OdometryNoise& noise) {
  const double before = turn_size(step.turn_before);
  const double after = turn_size(step.turn_after);
  const double distance_m = std::abs(step.distance_m);
  return {
      std::hypot(noise.turn_per_turn * before, noise.turn_per_metre * distance_m),
      std::hypot(noise.distance_per_metre * distance_m, noise.distance_per_turn * (before + after)),
      std::hypot(noise.turn_per_turn * after, noise.turn_per_metre * distance_m)};
}

OdometryStep perturbed(const OdometryStep& step, const OdometryNoise& noise, Random& random) {
  return perturbed_by(step_errors(step, noise), step, random);
}

OdometryStep perturbed_by(const StepErrors& errors, const OdometryStep& step, Random& random) {
  const double error_before = random.normal(0.0, errors.turn_before_rad);
  const double error_distance = random.normal(0.0, errors.distance_m);
  const double error_after = random.normal(0.0, errors.turn_after_rad);
  return {step.turn_before + Angle::from_radians(error_before), step.distance_m + error_distance,
          step.turn_after + Angle::from_radians(error_after)};
}

}  // namespace mapwright::navcore
