// The options that describe a laser scanner, shared by the verbs that cast rays.
#pragma once

#include <boost/program_options.hpp>

#include "navcore/rays/laser.hpp"
#include "navcore/sensors/laser_noise.hpp"

namespace mapwright::cli {

/// Adds --rays, --fov, --max-range and --laser-height, with the report's values as defaults.
void declare_laser_options(boost::program_options::options_description& options);

/// What they say. Throws Error (kUsage) for a laser that cannot be.
navcore::LaserModel laser_model(const boost::program_options::variables_map& values);

/// Adds --`noise_name` (σL, metres) and --occlusion.
void declare_noise_options(boost::program_options::options_description& options,
                           const char* noise_name, const char* default_noise_m);
navcore::LaserNoise laser_noise(const boost::program_options::variables_map& values,
                                const char* noise_name);

}  // namespace mapwright::cli
