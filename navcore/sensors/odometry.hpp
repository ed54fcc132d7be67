// Wheel encoders: the odometry motion model.
#pragma once

#include "mapcore/angle.hpp"
#include "mapcore/random.hpp"

namespace mapwright::navcore {

/// A movement as the robot itself feels it: turn, drive straight, turn (Thrun, Burgard, Fox,
/// Probabilistic Robotics, 2005, section 5.4).
struct OdometryStep {
  Angle turn_before;
  double distance_m = 0.0;  ///< negative when driven backwards
  Angle turn_after;
};

/// The movement that leads from one pose to the other; a way that leads backwards is driven
/// backwards. Of a way below a centimetre the direction says nothing: only what leads ahead or back
/// counts, and the whole turn comes after.
OdometryStep step_between(const Pose& from, const Pose& to);

/// Where the movement leads.
Pose moved(const Pose& pose, const OdometryStep& step);

/// Standard deviations of the movement's errors, in proportion to the movement: α1 to α4 of the
/// book, as standard deviations where the book has variances.
struct OdometryNoise {
  double turn_per_turn = 0.05;       ///< radians a radian (α1)
  double turn_per_metre = 0.01;      ///< radians a metre (α2)
  double distance_per_metre = 0.03;  ///< metres a metre (α3)
  double distance_per_turn = 0.01;   ///< metres a radian (α4)
};

/// Standard deviations of the errors of one movement's parts.
struct StepErrors {
  double turn_before_rad = 0.0;
  double distance_m = 0.0;
  double turn_after_rad = 0.0;
};

StepErrors step_errors(const OdometryStep& step, const OdometryNoise& noise);

/// The movement with errors: what encoders report of a true movement, or, the model being
/// symmetric, a movement that the report may stand for.
OdometryStep perturbed(const OdometryStep& step, const OdometryNoise& noise, Random& random);

/// The same for many draws of one movement: `errors` = step_errors(step, noise).
OdometryStep perturbed_by(const StepErrors& errors, const OdometryStep& step, Random& random);

}  // namespace mapwright::navcore
