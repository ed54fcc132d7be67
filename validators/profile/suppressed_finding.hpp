// A finding that does not count, and why.
#pragma once

#include <string>

#include "mapcore/finding.hpp"
#include "validators/fingerprint.hpp"

namespace mapwright::validators {

struct SuppressedFinding {
  Finding finding;
  Fingerprint name;
  std::string by;      ///< "site/.mapwright.yaml:12:5" for a suppression, the path of a baseline
  std::string reason;  ///< the suppression's; of a baseline "known since the baseline"

  friend bool operator==(const SuppressedFinding&, const SuppressedFinding&) = default;
};

}  // namespace mapwright::validators
