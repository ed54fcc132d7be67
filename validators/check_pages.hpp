// The pages of docs/checks, as the program carries them.
#pragma once

#include <string_view>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// The page docs/checks/<CODE>.md (Markdown) of a finding.
std::string_view check_page(FindingCode code);

}  // namespace mapwright::validators
