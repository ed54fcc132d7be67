// Private to this folder: drawings, whose layers are theirs and not GDAL's single one.
#pragma once

#include <memory>
#include <string>

#include "converter/gdal/gdal_reader.hpp"

namespace mapwright::converter {

/// Opens a DXF file: each layer of the drawing that holds something is a layer of the source,
/// arcs, circles, ellipses and splines are marked as curves, and LayerInfo::metres_per_local_unit
/// is what $INSUNITS says, if a drawing of that size can be a place at all (many are stated in
/// millimetres and drawn in metres; a warning tells).
OpenedReader open_dxf(const GdalInput& input, const DriverNotice& notice);

/// True for the name of a DXF file.
bool is_dxf(const std::string& path);

}  // namespace mapwright::converter
