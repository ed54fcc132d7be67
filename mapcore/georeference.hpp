// Where on the Earth a map lies: the sidecar <map>.georef.json.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/result.hpp"

namespace mapwright {

enum class FrameProjection {
  kTransverseMercator,  ///< "tmerc": centred on the origin, scale 1 there
  kEastNorthUp,         ///< "enu": local tangent plane at the origin
};

std::string_view to_string(FrameProjection projection);
std::optional<FrameProjection> frame_projection(std::string_view name);

/// A source that went into the map.
struct GeoreferenceSource {
  std::string path;  ///< relative to the map's folder
  std::string layer;
  std::string crs;  ///< "EPSG:25831", or WKT where it has no code; empty for plain local metres

  friend bool operator==(const GeoreferenceSource&, const GeoreferenceSource&) = default;
};

/// Ties the map frame to WGS 84. Map coordinates (x, y) are metres on the projection plane at the
/// origin, turned so that +y points to `heading_deg`.
struct Georeference {
  double origin_latitude_deg = 0.0;
  double origin_longitude_deg = 0.0;
  double origin_height_m = 0.0;  ///< above the ellipsoid
  double heading_deg = 0.0;      ///< of the map's +y axis, clockwise from true north
  FrameProjection projection = FrameProjection::kTransverseMercator;
  std::string wkt2;  ///< of the map frame, for GIS programs; may be empty
  std::vector<GeoreferenceSource> sources;

  friend bool operator==(const Georeference&, const Georeference&) = default;
};

/// JSON with "schema": "mapwright.georef/1"; ends with a line break.
std::string format_georeference(const Georeference& georeference);

/// Errors: not JSON, another schema, missing or impossible values (latitude beyond ±90 …).
Result<Georeference> parse_georeference(std::string_view json);

/// Path of the sidecar beside a map: "site/campus.txt" → "site/campus.georef.json"; a name without
/// ".txt" keeps all of itself: "campus" → "campus.georef.json".
std::string sidecar_path(std::string_view map_path);

}  // namespace mapwright
