// The options of `mapwright check` that say what the robot is and what is asked of a map.
#pragma once

#include <boost/program_options.hpp>
#include <set>
#include <string>

#include "validators/deployment/deployment_gate.hpp"
#include "validators/profile/profile.hpp"

namespace mapwright::cli {

/// Adds --robot-radius, --ramps, --plans, --trials, the laser's and more.
void declare_gate_options(boost::program_options::options_description& options);

/// What they say. Throws Error (kUsage) for what makes no sense.
validators::GateOptions gate_options(const boost::program_options::variables_map& values);

/// Names of the options that stand on the command line.
std::set<std::string> given_options(const boost::program_options::variables_map& values);

/// The options with what the profile says, but for the options that were given.
validators::GateOptions with_profile(validators::GateOptions options, validators::Profile profile,
                                     const std::set<std::string>& given);

}  // namespace mapwright::cli
