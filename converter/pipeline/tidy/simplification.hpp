// Fewer vertices within a bound, on request (--simplify).
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Leaves out vertices of walls and outlines (Douglas & Peucker 1973), so that the Hausdorff
/// distance between a chain before and after is `tolerance_m` at most. Vertices that two obstacles
/// share stay, and nothing is left out where another obstacle is nearer than twice the tolerance,
/// so what touches goes on touching and nothing new crosses. The ledger says how far the drawing
/// moved (C251).
void simplify_drafts(Workspace& workspace, double tolerance_m);

}  // namespace mapwright::converter
