// Changing the text of a map by the edits that findings carry.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"

namespace mapwright {

/// The text after the edits. Requires edits in the order of the text that do not overlap.
std::string apply_edits(std::string_view text, const std::vector<TextEdit>& edits);

}  // namespace mapwright
