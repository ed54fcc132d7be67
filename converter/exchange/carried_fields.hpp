// Fields within one text, for formats without fields of their own (DXF).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// "name=value" items; blanks, '%', '+', control characters and what is not ASCII stand as %XX.
/// Values that are not set are left out.
std::vector<std::string> carried_items(const std::vector<std::string>& names,
                                       const std::vector<FieldValue>& values);

/// The items behind the word MAPWRIGHT in a text, with blanks between them; a word that begins with
/// '+' goes on with the item before it, and words without '=' (DXF's group codes) mean nothing.
/// Nothing where MAPWRIGHT is missing.
std::optional<std::map<std::string, std::string, std::less<>>> read_carried_items(
    std::string_view text);

}  // namespace mapwright::converter
