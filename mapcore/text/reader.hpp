// Reader of the map text format.
#pragma once

#include <string>

#include "mapcore/progress.hpp"
#include "mapcore/text/document.hpp"

namespace mapwright {

/// Reads a map (report, appendix A; grammar in docs/format.md).
///
/// Never fails: every defect becomes a finding with line and column, reading goes on at the next
/// '#', and the document's map holds all records that could be understood. LF, CRLF and a UTF-8
/// byte order mark are read; numbers have '.' as decimal point in every locale. A declared segment
/// count is compared, never trusted: memory is bounded by the size of the text.
///
/// `progress` counts KiB of the text.
MapDocument read_map(MapText text, const Progress& progress = {});

}  // namespace mapwright
