// Findings as JSON.
#pragma once

#include <string>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// The object that docs/cli.md describes, on one line: code, severity, message, line, column, x, y,
/// obstacle, segment; what is not known is null. Behind them, where there are such, geometry, fix
/// and features: nothing of a finding is left out.
std::string finding_json(const Finding& finding);

}  // namespace mapwright::validators
