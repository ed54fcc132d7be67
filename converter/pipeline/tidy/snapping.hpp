// Vertices that nearly meet made to meet, on request (--snap).
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Moves each vertex to the first one, in the order of the drafts, that lies nearer than
/// `tolerance_m` and that has itself not been moved; so nothing moves further than that, however
/// many vertices lie in a row. Drafts that would cross themselves stay as they are, as do stairs
/// and ramps. The ledger says how far (C250).
void snap_vertices(Workspace& workspace, double tolerance_m);

}  // namespace mapwright::converter
