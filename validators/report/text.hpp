// Findings as lines of text, the way compilers write them.
#pragma once

#include <string>
#include <string_view>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// "campus.txt:41:7: error: segment 3 of obstacle 26 … [G104]"; without line and column where the
/// finding has none.
std::string finding_line(std::string_view path, const Finding& finding, bool colour = false);

}  // namespace mapwright::validators
