// The map frame as text that GIS programs read.
#pragma once

#include <string>

#include "mapcore/georeference.hpp"

namespace mapwright::converter {

/// WKT2:2019 of the map frame. Turned frames are a derived projected CRS: the projection, followed
/// by EPSG's affine parametric transformation (method 9624), which PROJ carries out. `enu` is the
/// ellipsoidal orthographic projection, stretched to the origin's height (agrees with the tangent
/// plane within 1 mm to 10 km).
std::string frame_wkt2(const Georeference& georeference);

}  // namespace mapwright::converter
