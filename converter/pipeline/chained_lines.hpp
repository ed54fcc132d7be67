// Loose lines of drawings, joined.
#pragma once

#include <vector>

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Joins open walls of the same layer, kind, height and meaning end to end into chains, where
/// exactly two ends meet at a point; `joins[source]` says for each layer whether its lines may be
/// joined. Drawings cut walls into single lines, and their direction means nothing, so that lines
/// may be turned. A chain stays simple: what would make it cross or touch itself is not joined. The
/// ledger tells each feature that became part of a chain (C230).
void chain_lines(const std::vector<bool>& joins, Workspace& workspace);

}  // namespace mapwright::converter
