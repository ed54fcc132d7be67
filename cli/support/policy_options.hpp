// The options that say by which rules a site judges findings.
#pragma once

#include <boost/program_options.hpp>
#include <string>

#include "validators/profile/date.hpp"

namespace mapwright::cli {

struct PolicyOptions {
  std::string config;  ///< path of the configuration file; empty: the one found beside each map
  bool no_config = false;
  std::string profile;         ///< empty: the configuration's choice
  std::string baseline;        ///< path; empty: none
  std::string write_baseline;  ///< path; empty: none
  validators::Date today;
};

/// Adds --config, --no-config, --profile and --today.
void declare_config_options(boost::program_options::options_description& options);

/// Adds those, and --baseline and --write-baseline.
void declare_policy_options(boost::program_options::options_description& options);

/// What they say; baselines only where they were declared. Throws Error (kUsage) for what makes no
/// sense.
PolicyOptions policy_options(const boost::program_options::variables_map& values);

}  // namespace mapwright::cli
