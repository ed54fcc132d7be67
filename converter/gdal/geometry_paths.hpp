// Private to this folder: OGR geometries taken apart into paths.
#pragma once

#include "converter/source/feature.hpp"

class OGRGeometry;

namespace mapwright::converter {

/// Appends the paths of a geometry (null: none). Arcs become chords nearer than `sagitta`, in the
/// unit of the coordinates.
void append_paths(const OGRGeometry* geometry, double sagitta, SourceGeometry& paths);

}  // namespace mapwright::converter
