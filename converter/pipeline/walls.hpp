// Walls: lines as they are drawn.
#pragma once

#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Writes a feature of kind wall: each line a chain that keeps its drawing direction (free space on
/// the right) and is open, also where it ends where it began. Polygons are written as solids are.
void add_wall(const FeatureTask& task, Workspace& workspace);

/// The same with a given height.
void add_wall(const FeatureTask& task, double height_m, Workspace& workspace);

}  // namespace mapwright::converter
