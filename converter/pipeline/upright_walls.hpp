// Walls along the footprints of upright faces.
#pragma once

#include "converter/pipeline/upright_faces.hpp"
#include "converter/pipeline/workspace.hpp"

namespace mapwright::converter {

/// Makes walls of a feature's upright faces, free on both sides, and returns what else its geometry
/// has. No wall is made of a face that lies on outlines of that rest, which has it already.
SourceGeometry add_upright_walls(const FeatureTask& task, const std::vector<UprightFace>& faces,
                                 Workspace& workspace);

}  // namespace mapwright::converter
