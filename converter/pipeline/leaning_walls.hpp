// Walls that lean on solids.
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Turns open walls that lie on the outline of a solid with their free side towards it, and says
/// so: drawn once as a line and once as a polygon, the polygon tells which side is free. A wall
/// between two outlines, or one that would have to be turned in part, stays as it is drawn.
void turn_leaning_walls(Workspace& workspace);

}  // namespace mapwright::converter
