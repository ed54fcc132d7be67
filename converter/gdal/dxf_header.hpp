// Private to this folder: what GDAL does not tell of a DXF file's header.
#pragma once

#include <optional>
#include <string>

namespace mapwright::converter {

/// Metres per drawing unit by the header variable $INSUNITS (DXF Reference, HEADER section);
/// nothing where the file states none ("unitless") or a unit without fixed length.
std::optional<double> dxf_metres_per_unit(const std::string& path);

/// True for a drawing whose texts are UTF-8: some are not ASCII, and all are sound UTF-8. The
/// header variable $DWGCODEPAGE names a code page all the same, since AutoCAD 2007 writes UTF-8
/// only.
bool dxf_is_utf8(const std::string& path);

}  // namespace mapwright::converter
