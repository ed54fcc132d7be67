// What is wrong with the configuration files of a run, as reports beside those of the maps.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "validators/profile/date.hpp"
#include "validators/profile/policy.hpp"
#include "validators/report/report.hpp"

namespace mapwright::cli {

/// Configuration files by their path; that of the empty path is none.
using Policies = std::map<std::string, validators::Policy>;

/// A report for each file with findings; they refer to `policies`. `used`: names of suppressions
/// that covered something. `every_map_was_seen`: only then is it known which of them nobody needs.
std::vector<validators::MapReport> policy_reports(const Policies& policies,
                                                  const std::set<std::string>& used,
                                                  bool every_map_was_seen, validators::Date today);

/// Digest of all that verdicts depend on: the files, and which suppressions have expired.
std::string policies_digest(const Policies& policies, validators::Date today);

}  // namespace mapwright::cli
