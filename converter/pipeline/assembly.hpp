// From drafts to the map: order, ids, border.
#pragma once

#include "converter/pipeline/converted_map.hpp"
#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Leaves out drafts of walls all of whose segments are steps of stairs too, and says so.
void drop_walls_that_are_steps(Workspace& workspace);

/// The map: obstacles by kind, then layer name, then the order of the sources, with ids from 1; so
/// the same layers in another format give the same map. The border is what features of kind border
/// span, else the extent of everything and the margin of the settings. Fills in the ledger's ids;
/// accounts that nothing came of are dropped. Empties the workspace of obstacles.
ConvertedMap assemble(Workspace& workspace);

}  // namespace mapwright::converter
