// Private to this folder: which reader knows a data set.
#pragma once

#include "converter/gdal/gdal_reader.hpp"

namespace mapwright::converter {

/// Opens a data set that is no archive, on disk or unpacked into memory: OSM by Osmium, IndoorGML,
/// CSV and DXF by readers of our own, all else by the drivers named.
OpenedReader open_single(const GdalInput& input, const DriverNotice& notice);

}  // namespace mapwright::converter
