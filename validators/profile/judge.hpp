// What a site makes of the findings of a map: severities, suppressions, baseline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "validators/fingerprint.hpp"
#include "validators/profile/baseline.hpp"
#include "validators/profile/date.hpp"
#include "validators/profile/policy.hpp"
#include "validators/profile/suppressed_finding.hpp"

namespace mapwright::validators {

/// What counts, and what does not.
struct Judgement {
  std::vector<Finding> findings;   ///< with the severities of the profile, in their order
  std::vector<Fingerprint> names;  ///< of each of them
  std::vector<SuppressedFinding> suppressed;
};

/// The map and the rules to judge it by.
struct JudgeContext {
  const MapDocument& document;
  const Policy& policy;
  Date today;
  std::string_view path;  ///< of the map from the policy's folder, with '/', for globs
  const std::vector<KnownFinding>* known = nullptr;  ///< what a baseline knows of the map
  std::string_view baseline_path = {};
};

/// Gives findings the profile's severities, drops those it turns off, sets those aside that a
/// suppression (the first that covers it and has not expired) or the baseline knows.
Judgement judge(std::vector<Finding> findings, const JudgeContext& context);

/// "PATH:LINE:COLUMN" of a suppression, as SuppressedFinding::by has it.
std::string suppression_name(const Policy& policy, const Suppression& suppression);

/// Findings about the configuration file itself, with places in it: suppressions that have expired
/// (C302), and, if `every_map_was_seen`, those that are in nobody's way (C301): their names are not
/// among `used`. Severities are those of the profile.
std::vector<Finding> policy_findings(const Policy& policy, const std::vector<std::string>& used,
                                     bool every_map_was_seen, Date today);

}  // namespace mapwright::validators
