// Lasers, and numbers that may be unknown, in JSON answers.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "navcore/rays/laser.hpp"
#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::cli {

/// JSON has no infinity: null stands for what is not known.
inline nlohmann::ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// Appends rays, fov_deg, max_range, laser_height, laser_noise and occlusion.
inline void add_laser(nlohmann::ordered_json& json, const navcore::LaserModel& laser,
                      const navcore::LaserNoise& noise) {
  json["rays"] = laser.rays;
  json["fov_deg"] = laser.fov_deg;
  json["max_range"] = laser.max_range_m;
  json["laser_height"] = laser.height_m;
  json["laser_noise"] = noise.sigma_m;
  json["occlusion"] = noise.occlusion;
}

}  // namespace mapwright::cli
