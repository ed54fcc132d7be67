// Geometries and reference systems of GML documents that no driver of GDAL reads whole.
#pragma once

#include <string>

#include "converter/gdal/crs.hpp"
#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// Appends the paths of one GML geometry, an element as text with all that it refers to in it. Arcs
/// become chords nearer than `sagitta`, in the unit of the coordinates. Returns what GDAL says is
/// wrong with it; empty for a sound one.
std::string append_gml(const std::string& element, double sagitta, SourceGeometry& paths);

struct GmlCrs {
  Crs crs;                   ///< none where the name says nothing
  bool north_first = false;  ///< coordinates are northing or latitude before easting or longitude
};

/// What an `srsName` means: "EPSG:25831" is easting first whatever the authority says, as "urn:…"
/// and "http://www.opengis.net/def/crs/…" the authority's order holds.
GmlCrs gml_crs(const std::string& srs_name);

}  // namespace mapwright::converter
