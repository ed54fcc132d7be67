#include "converter/gdal/surface_footprint.hpp"

namespace mapwright::converter {
namespace {

// Walls stand upright: what rounding leaves of their area is nothing beside the square of their
// length.
constexpr double kLeastShare = 1e-9;

bool covers_ground(const OGRPolygon& face) {
  const auto* ring = face.getExteriorRing();
  if (ring == nullptr) return false;
  const double length = ring->get_Length();
  return face.get_Area() > kLeastShare * length * length;
}

}  // namespace

std::unique_ptr<OGRGeometry> footprint_of(const OGRPolyhedralSurface& surface) {
  OGRMultiPolygon faces;
  for (const auto* face : surface) {
    auto flat = std::make_unique<OGRPolygon>(*face);  // also of a triangle
    flat->flattenTo2D();
    if (covers_ground(*flat)) faces.addGeometryDirectly(flat.release());
  }
  std::unique_ptr<OGRGeometry> united(faces.IsEmpty() ? nullptr : faces.UnionCascaded());
  if (united && united->IsEmpty()) united.reset();
  return united;
}

}  // namespace mapwright::converter
