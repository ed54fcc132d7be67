// Private to this folder: tables with a column of shapes.
#pragma once

#include <string>

#include "converter/gdal/gdal_reader.hpp"

namespace mapwright::converter {

/// True for a CSV file, by its name.
bool is_csv(const std::string& path);

/// Opens a CSV file. Its shapes are in the column WKT, or geom, geometry, the_geom or wkt_geom: as
/// WKT, EWKT, GeoJSON or hexadecimal WKB. A text there that is no shape makes the feature broken,
/// for a table that was cut short is otherwise none the worse for it. A table without such a column
/// is warned of.
OpenedReader open_csv(const GdalInput& input, const DriverNotice& notice);

/// Names of such columns as GDAL's open option GEOM_POSSIBLE_NAMES takes them.
inline constexpr const char* kShapeColumnsOption =
    "GEOM_POSSIBLE_NAMES=WKT,_WKT*,geom,geometry,the_geom,wkt_geom";

}  // namespace mapwright::converter
