// Private to this folder: what GDAL's reference systems say, as values.
#pragma once

#include "converter/gdal/crs.hpp"

class OGRSpatialReference;

namespace mapwright::converter {

/// Values of a reference system; none for a null pointer and for what formats write when they know
/// nothing ("Undefined geographic SRS", local systems without a place on Earth).
Crs crs_of(const OGRSpatialReference* reference);

}  // namespace mapwright::converter
