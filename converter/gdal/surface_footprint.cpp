#include "converter/gdal/surface_footprint.hpp"

#include <algorithm>
#include <cmath>

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

// Its area seen from the side, by the formula of Newell: of one that is a line in space nothing.
bool covers_air(const OGRPolygon& face) {
  const auto* ring = face.getExteriorRing();
  if (ring == nullptr || !face.Is3D()) return false;
  double x = 0.0, y = 0.0;
  for (int i = 0; i + 1 < ring->getNumPoints(); ++i) {
    const double height = ring->getZ(i) + ring->getZ(i + 1);
    x += (ring->getY(i) - ring->getY(i + 1)) * height;
    y += (ring->getX(i + 1) - ring->getX(i)) * height;
  }
  return std::hypot(x, y) > 0.0;
}

OGRPolygon seen_from_above(const OGRPolygon& face) {
  OGRPolygon flat(face);  // also of a triangle
  flat.flattenTo2D();
  return flat;
}

// The footprint and what rounding may leave beside it.
std::unique_ptr<OGRGeometry> widened(const OGRGeometry& footprint) {
  constexpr double kShare = 1e-6;
  OGREnvelope box;
  footprint.getEnvelope(&box);
  const double width = std::max(box.MaxX - box.MinX, box.MaxY - box.MinY);
  return std::unique_ptr<OGRGeometry>(footprint.Buffer(kShare * width, 1));
}

}  // namespace

std::unique_ptr<OGRGeometry> footprint_of(const OGRPolyhedralSurface& surface) {
  OGRMultiPolygon faces;
  for (const auto* face : surface) {
    auto flat = std::make_unique<OGRPolygon>(seen_from_above(*face));
    if (covers_ground(*flat)) faces.addGeometryDirectly(flat.release());
  }
  std::unique_ptr<OGRGeometry> united(faces.IsEmpty() ? nullptr : faces.UnionCascaded());
  if (united && united->IsEmpty()) united.reset();
  return united;
}

std::vector<const OGRPolygon*> upright_faces_beside(const OGRPolyhedralSurface& surface,
                                                    const OGRGeometry* footprint) {
  std::vector<const OGRPolygon*> upright;
  for (const auto* face : surface) {
    if (!covers_ground(seen_from_above(*face)) && covers_air(*face)) upright.push_back(face);
  }
  if (footprint == nullptr || upright.empty()) return upright;
  const auto covered = widened(*footprint);
  std::erase_if(upright, [&](const OGRPolygon* face) {
    OGRLineString line(*face->getExteriorRing());
    line.flattenTo2D();
    return covered && covered->Contains(&line) != FALSE;
  });
  return upright;
}

}  // namespace mapwright::converter
