#include "converter/source/feature.hpp"

namespace mapwright::converter {
namespace {

GeometryKind kind_of(PathRole role) {
  switch (role) {
    case PathRole::kPoint:
      return GeometryKind::kPoint;
    case PathRole::kLine:
      return GeometryKind::kLine;
    case PathRole::kOuterRing:
    case PathRole::kInnerRing:
      return GeometryKind::kPolygon;
  }
  return GeometryKind::kNone;
}

}  // namespace

std::string_view to_string(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::kNone:
      return "none";
    case GeometryKind::kPoint:
      return "point";
    case GeometryKind::kLine:
      return "line";
    case GeometryKind::kPolygon:
      return "polygon";
    case GeometryKind::kMixed:
      return "mixed";
  }
  return "none";
}

GeometryKind geometry_kind(const SourceGeometry& geometry) {
  auto kind = GeometryKind::kNone;
  for (const auto& path : geometry.paths) {
    const auto other = kind_of(path.role);
    if (kind != GeometryKind::kNone && kind != other) return GeometryKind::kMixed;
    kind = other;
  }
  return kind;
}

Box extent_of(const SourceGeometry& geometry) {
  Box box = kEmptyBox;
  for (std::size_t i = 0; i < geometry.xs.size(); ++i) box.add({geometry.xs[i], geometry.ys[i]});
  return box;
}

}  // namespace mapwright::converter
