// Repairs of single records, as edits of the text.
#pragma once

#include <cstddef>
#include <optional>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright::validators {

/// Writes the ends of a segment (0-based) the other way round, digit by digit as they stand.
TextEdit swapped_ends(const MapDocument& document, std::size_t obstacle, std::size_t segment);

/// Writes the border's numbers with the top-left corner first; nothing where no order of them
/// encloses an area.
std::optional<TextEdit> ordered_border(const MapDocument& document);

}  // namespace mapwright::validators
