// What a source hands over: features as plain values, free of any library's types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// A field's value; monostate where the feature has none.
using FieldValue = std::variant<std::monostate, std::int64_t, double, std::string>;

inline bool is_null(const FieldValue& value) {
  return std::holds_alternative<std::monostate>(value);
}

/// What a path of coordinates is.
enum class PathRole : std::uint8_t { kPoint, kLine, kOuterRing, kInnerRing };

/// A run of coordinates within SourceGeometry::xs and ys.
struct SourcePath {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  PathRole role = PathRole::kLine;
  bool curved = false;  ///< held arcs, which are chords now
};

/// A geometry taken apart: each inner ring follows the outer ring it lies in. Coordinates are in
/// the source's CRS, x to the east (longitude), y to the north (latitude).
struct SourceGeometry {
  std::vector<double> xs, ys;
  std::vector<double> zs;  ///< as long as xs where the source has heights, else empty
  std::vector<SourcePath> paths;
  std::string type;         ///< "MULTIPOLYGON"; empty for a feature without geometry
  std::string unsupported;  ///< type of a part no path can stand for (a relation …); empty if none

  void clear() {
    xs.clear();
    ys.clear();
    zs.clear();
    paths.clear();
    type.clear();
    unsupported.clear();
  }
};

/// One feature. Reused from feature to feature by readers, so that nothing is allocated anew.
struct SourceFeature {
  std::int64_t fid = 0;
  std::vector<FieldValue> values;  ///< by LayerInfo::fields
  SourceGeometry geometry;
  std::string broken;                 ///< why its geometry cannot be read; empty for sound features
  std::string lost;                   ///< what else it has that cannot be read; empty if nothing
  bool selected = true;               ///< false: `--where` does not hold for it
  std::vector<std::string> warnings;  ///< what the driver said while reading it
  std::vector<std::string>
      reencoded;  ///< fields whose text was not UTF-8 and was read as ISO-8859-1
};

/// Kind of geometry a layer or feature holds, as far as rules care.
enum class GeometryKind : std::uint8_t { kNone, kPoint, kLine, kPolygon, kMixed };

std::string_view to_string(GeometryKind kind);

/// What a feature's paths are: kMixed for a collection of several kinds.
GeometryKind geometry_kind(const SourceGeometry& geometry);

/// Box around all coordinates.
Box extent_of(const SourceGeometry& geometry);

}  // namespace mapwright::converter
