// A configuration file: profiles and suppressions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mapcore/result.hpp"
#include "validators/profile/profile.hpp"
#include "validators/profile/suppression.hpp"

namespace mapwright::validators {

/// What a configuration file says, with one of its profiles chosen.
struct Policy {
  std::string path;  ///< of the file, as messages name it; empty: none
  std::string text;  ///< of the file
  Profile profile;
  std::vector<Suppression> suppressions;
};

/// Reads a configuration file (YAML; docs/configuration.md) and resolves the profile of that name,
/// or for an empty name the one the file chooses, or "default". An empty text is no configuration.
///
/// Failure: all mistakes, a line "PATH:LINE:COLUMN: error: …" each (kInput); a profile name that
/// neither the file nor the program knows (kUsage).
Result<Policy> read_policy(std::string text, std::string path, std::string_view profile_name = "");

}  // namespace mapwright::validators
