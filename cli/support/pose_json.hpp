// Poses in JSON answers.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "mapcore/angle.hpp"

namespace mapwright::cli {

/// An angle in degrees as a person wrote it: without the last digits of its way through radians.
inline double plain_degrees(Angle angle) {
  return std::round(angle.degrees() * 1e9) / 1e9;
}

/// {"x", "y", "theta_deg"}
inline nlohmann::ordered_json pose_json(const Pose& pose) {
  nlohmann::ordered_json json;
  json["x"] = pose.x;
  json["y"] = pose.y;
  json["theta_deg"] = plain_degrees(pose.theta);
  return json;
}

}  // namespace mapwright::cli
