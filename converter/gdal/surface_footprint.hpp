// Private to this folder: what a surface in space covers on the ground.
#pragma once

#include <ogr_geometry.h>

#include <memory>

namespace mapwright::converter {

/// The union of a surface's faces (polyhedral surface, TIN) seen from above, without heights: a
/// polygon or multipolygon. Null where no face covers any ground or GEOS cannot unite them.
std::unique_ptr<OGRGeometry> footprint_of(const OGRPolyhedralSurface& surface);

}  // namespace mapwright::converter
