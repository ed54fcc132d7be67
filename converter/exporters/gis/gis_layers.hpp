// A map as layers of a GIS: plain values that writers of formats turn into files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

enum class GisGeometry { kNone, kLine, kPolygon };
enum class GisType { kText, kInteger, kReal };

struct GisColumn {
  std::string name;
  GisType type = GisType::kText;
};

/// A line is one path; a polygon its outer ring and its holes, first points not repeated.
struct GisFeature {
  GisGeometry geometry = GisGeometry::kNone;
  std::vector<std::vector<Point>> paths;
  std::vector<FieldValue> values;  ///< by GisLayer::columns
  double height_m = 0.0;           ///< greatest height, for formats that draw it
};

struct GisLayer {
  std::string name;
  GisGeometry geometry = GisGeometry::kPolygon;
  std::vector<GisColumn> columns;
  std::vector<GisFeature> features;
};

/// The layers border, solids, walls, steps and ramps (empty ones included but without features), in
/// map coordinates; fields as docs/round-trip.md describes them.
///
/// Outlines that are simple become polygons: a clockwise one that `inner_of` ties to an outline
/// around it, or that simply lies in one, is its hole. Everything else becomes lines, one for each
/// run of joined segments of the same height and kind; an obstacle without segments a feature
/// without geometry.
struct GisLayerOptions {
  std::string crs;            ///< what the border's field of that name shall say
  double resolution_m = 0.0;  ///< likewise
  bool join_holes = true;     ///< false: a hole is a polygon of its own
};
std::vector<GisLayer> gis_layers(const Map& map, const std::optional<Georeference>& georeference,
                                 const GisLayerOptions& options);

/// All features in layers of one geometry ("polygons" and "lines"), or in a single one.
std::vector<GisLayer> by_geometry(std::vector<GisLayer> layers);
GisLayer in_one_layer(std::vector<GisLayer> layers, const std::string& name);

}  // namespace mapwright::converter
