#include "converter/gdal/geometry_paths.hpp"

#include <ogr_geometry.h>

#include "converter/gdal/surface_footprint.hpp"
#include "converter/source/arc.hpp"

namespace mapwright::converter {
namespace {

class PathBuilder {
 public:
  PathBuilder(double sagitta, SourceGeometry& out) : sagitta_(sagitta), out_(out) {}

  void add(const OGRGeometry& geometry);

  /// Whether heights mean nothing: the ground that a surface in space covers has none.
  bool is_flat() const { return has_footprints_ && !has_upright_faces_; }

 private:
  void add_point(const OGRPoint& point);
  void add_polygon(const OGRCurvePolygon& polygon);
  bool add_surface(const OGRPolyhedralSurface& surface);
  void add_curve_path(const OGRCurve& curve, PathRole role);
  void add_curve(const OGRCurve& curve, bool skip_first);
  void add_line(const OGRSimpleCurve& line, bool skip_first);
  void add_arcs(const OGRCircularString& arcs, bool skip_first);
  void add_vertex(double x, double y, double z);

  double sagitta_;
  SourceGeometry& out_;
  bool curved_ = false;
  bool has_footprints_ = false;
  bool has_upright_faces_ = false;
};

void PathBuilder::add_vertex(double x, double y, double z) {
  out_.xs.push_back(x);
  out_.ys.push_back(y);
  out_.zs.push_back(z);
}

void PathBuilder::add_line(const OGRSimpleCurve& line, bool skip_first) {
  const int count = line.getNumPoints();
  for (int i = skip_first ? 1 : 0; i < count; ++i) {
    add_vertex(line.getX(i), line.getY(i), line.getZ(i));
  }
}

void PathBuilder::add_arcs(const OGRCircularString& arcs, bool skip_first) {
  const auto point = [&](int i) { return Point{arcs.getX(i), arcs.getY(i)}; };
  if (!skip_first && arcs.getNumPoints() > 0) add_vertex(arcs.getX(0), arcs.getY(0), arcs.getZ(0));
  std::vector<Point> chords;
  for (int i = 0; i + 2 < arcs.getNumPoints(); i += 2) {
    append_arc(point(i), point(i + 1), point(i + 2), sagitta_, chords);
  }
  for (const Point p : chords) add_vertex(p.x, p.y, arcs.getZ(0));
  curved_ = true;
}

void PathBuilder::add_curve(const OGRCurve& curve, bool skip_first) {
  switch (wkbFlatten(curve.getGeometryType())) {
    case wkbCircularString:
      add_arcs(*curve.toCircularString(), skip_first);
      break;
    case wkbCompoundCurve: {
      const auto& compound = *curve.toCompoundCurve();
      for (int i = 0; i < compound.getNumCurves(); ++i) {
        add_curve(*compound.getCurve(i), skip_first || i > 0);
      }
      break;
    }
    default:
      add_line(*curve.toSimpleCurve(), skip_first);
      break;
  }
}

void PathBuilder::add_curve_path(const OGRCurve& curve, PathRole role) {
  const auto first = static_cast<std::uint32_t>(out_.xs.size());
  curved_ = false;
  add_curve(curve, false);
  const auto count = static_cast<std::uint32_t>(out_.xs.size()) - first;
  if (count > 0) out_.paths.push_back({first, count, role, curved_});
}

void PathBuilder::add_point(const OGRPoint& point) {
  if (point.IsEmpty()) return;
  out_.paths.push_back({static_cast<std::uint32_t>(out_.xs.size()), 1, PathRole::kPoint, false});
  add_vertex(point.getX(), point.getY(), point.getZ());
}

void PathBuilder::add_polygon(const OGRCurvePolygon& polygon) {
  if (polygon.IsEmpty()) return;
  add_curve_path(*polygon.getExteriorRingCurve(), PathRole::kOuterRing);
  for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
    add_curve_path(*polygon.getInteriorRingCurve(i), PathRole::kInnerRing);
  }
}

// A map has no third dimension: of a building in space the ground it covers, and of what stands
// beside that the faces, which become walls.
bool PathBuilder::add_surface(const OGRPolyhedralSurface& surface) {
  const auto footprint = footprint_of(surface);
  const auto upright = upright_faces_beside(surface, footprint.get());
  if (footprint) add(*footprint);
  for (const auto* face : upright) add_polygon(*face);
  has_footprints_ = has_footprints_ || footprint;
  has_upright_faces_ = has_upright_faces_ || !upright.empty();
  return footprint || !upright.empty();
}

void PathBuilder::add(const OGRGeometry& geometry) {
  const auto type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPoint) return add_point(*geometry.toPoint());
  if (OGR_GT_IsSubClassOf(type, wkbCurvePolygon)) return add_polygon(*geometry.toCurvePolygon());
  if (OGR_GT_IsCurve(type)) return add_curve_path(*geometry.toCurve(), PathRole::kLine);
  if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const auto* part : *geometry.toGeometryCollection()) add(*part);
    return;
  }
  const bool is_surface = OGR_GT_IsSubClassOf(type, wkbPolyhedralSurface) != FALSE;
  if (is_surface && add_surface(*geometry.toPolyhedralSurface())) return;
  out_.unsupported = geometry.getGeometryName();
}

}  // namespace

void append_paths(const OGRGeometry* geometry, double sagitta, SourceGeometry& paths) {
  if (geometry == nullptr) return;
  paths.type = geometry->getGeometryName();
  PathBuilder builder(sagitta, paths);
  builder.add(*geometry);
  if (!geometry->Is3D() || builder.is_flat()) paths.zs.clear();
}

}  // namespace mapwright::converter
