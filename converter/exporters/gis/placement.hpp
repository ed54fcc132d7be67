// Private to this folder: exported coordinates on their way to a CRS.
#pragma once

#include <vector>

#include "converter/exporters/gis/gis_layers.hpp"
#include "converter/gdal/crs.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// Takes all points from the map frame to a CRS, in place, so exactly that converting them back
/// gives each within a tenth of the resolution: PROJ's ways there and back need not be each other's
/// inverse (datum shifts), so every point is taken back and corrected by what it is off.
///
/// Fails (kUsage) where the CRS does not cover a point, or its doubles are too coarse for the
/// resolution there.
Result<void> place(std::vector<GisLayer>& layers, const Georeference& georeference, const Crs& crs,
                   double resolution_m);

}  // namespace mapwright::converter
