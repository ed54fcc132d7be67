// Findings as layers of a GIS: the defects themselves, where they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// What was found in one map.
struct MapFindings {
  std::string map;  ///< path as messages name it
  std::vector<Finding> findings;
  std::optional<Georeference> georeference;
};

/// The bytes of a GeoPackage with three layers:
/// - findings: every finding once, as the points of its defect (crossings, open ends), else its
///   place on the map, else where its lines begin, else without geometry;
/// - finding_lines, finding_areas: the segments, chains and outlines of those that have some.
///
/// Columns: finding (the number that joins the layers, from 1), map, code, name, severity, message,
/// line, column, x, y (metres of the map), obstacle, segment, source. The CRS is the map's frame;
/// for maps of several frames longitude and latitude (WGS 84); for maps without sidecar undefined
/// Cartesian metres. Among maps with sidecar, those without have no geometry.
///
/// The same findings give the same bytes. Fails (kOutput) where GDAL cannot write.
Result<std::string> findings_geopackage(const std::vector<MapFindings>& maps);

/// The same as one GeoJSON feature collection (RFC 7946), one feature a finding and kind of
/// geometry, the columns as properties. Longitude and latitude; for maps without sidecar metres of
/// the map, which "crs": null says.
std::string findings_geojson(const std::vector<MapFindings>& maps);

}  // namespace mapwright::converter
