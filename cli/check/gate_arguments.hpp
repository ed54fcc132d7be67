// The options of `mapwright check` that say what the robot is and what is asked of a map.
#pragma once

#include <boost/program_options.hpp>

#include "validators/deployment/deployment_gate.hpp"

namespace mapwright::cli {

/// Adds --robot-radius, --ramps, --plans, --trials, the laser's and more.
void declare_gate_options(boost::program_options::options_description& options);

/// What they say. Throws Error (kUsage) for what makes no sense.
validators::GateOptions gate_options(const boost::program_options::variables_map& values);

}  // namespace mapwright::cli
