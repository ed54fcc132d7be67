// Private to this folder: what a surface in space covers on the ground.
#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <vector>

namespace mapwright::converter {

/// The union of a surface's faces (polyhedral surface, TIN) seen from above, without heights: a
/// polygon or multipolygon. Null where no face covers any ground or GEOS cannot unite them.
std::unique_ptr<OGRGeometry> footprint_of(const OGRPolyhedralSurface& surface);

/// The faces that stand upright and not over `footprint` (null: none), which has the others.
std::vector<const OGRPolygon*> upright_faces_beside(const OGRPolyhedralSurface& surface,
                                                    const OGRGeometry* footprint);

}  // namespace mapwright::converter
