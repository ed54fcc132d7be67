// Private to this folder: Who is to blame for a gap too narrow.
#pragma once

#include <string>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "navcore/exact/exact_planner.hpp"

namespace mapwright::validators {

/// "0.42 m wide at (9.9, 4.6), between segment 3 of obstacle 7 (column,A5) and the border".
std::string gap_text(const Map& map, const navcore::Bottleneck& gap);

/// The gap as a line across it.
void show(const navcore::Bottleneck& gap, Finding& finding);

/// Shows the gap, and lets the finding name the first of its obstacles that is not the border: its
/// id, segment and place in the text.
void blame(const MapDocument& document, const navcore::Bottleneck& gap, Finding& finding);

}  // namespace mapwright::validators
