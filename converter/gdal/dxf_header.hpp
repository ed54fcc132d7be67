// Private to this folder: what GDAL does not tell of a DXF file's header.
#pragma once

#include <optional>
#include <string>

namespace mapwright::converter {

/// Metres per drawing unit by the header variable $INSUNITS (DXF Reference, HEADER section);
/// nothing where the file states none ("unitless") or a unit without fixed length.
std::optional<double> dxf_metres_per_unit(const std::string& path);

}  // namespace mapwright::converter
