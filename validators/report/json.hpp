// Findings as JSON.
#pragma once

#include <string>

#include "mapcore/finding.hpp"
#include "validators/fingerprint.hpp"

namespace mapwright::validators {

/// The object that docs/cli.md describes, on one line: code, severity, message, line, column, x, y,
/// obstacle, segment; what is not known is null. Behind them, where there are such, geometry, fix
/// and features: nothing of a finding is left out. With a name also its "fingerprint" by place and
/// its "subject_fingerprint".
std::string finding_json(const Finding& finding, const Fingerprint* name = nullptr);

}  // namespace mapwright::validators
