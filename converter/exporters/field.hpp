// Values all over a map, as files of GIS programs: a raster with bands, cells with attributes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "converter/exporters/gis/gis_layers.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/point.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// One value a cell, row by row from the lower left corner; NaN where there is none.
struct FieldBand {
  std::string name;  ///< "position_sd_major_m"
  std::string what;  ///< a line of explanation
  std::vector<float> values;
};

/// Square cells in the map frame.
struct Field {
  Point corner;  ///< lower left
  double cell_m = 1.0;
  std::size_t columns = 0, rows = 0;
  std::vector<FieldBand> bands;  ///< columns × rows values each
};

/// What stands in a raster where there is no value.
inline constexpr float kNoData = -9999.0F;

/// Writes a GeoTIFF with one band of 32-bit floats for each of the field's, named, compressed. The
/// CRS is transverse Mercator at the origin of the map; a turned map frame becomes a turned
/// geotransform, and without georeference the raster has the map's metres and no CRS. The
/// north-west pixel comes first, as rasters have it. Fails (kOutput) where GDAL cannot write.
Result<void> write_field_geotiff(const Field& field,
                                 const std::optional<Georeference>& georeference,
                                 const std::string& path);

/// Writes a GeoPackage with the layer `cells` (a square for each cell that has a value in some
/// band, the bands as columns) and the layers given. Fails (kOutput) where GDAL cannot write.
Result<void> write_field_geopackage(const Field& field, const std::vector<GisLayer>& layers,
                                    const std::optional<Georeference>& georeference,
                                    const std::string& path);

/// Outer rings and holes around joined cells (indices into the field, ascending), as the paths of
/// polygons: one polygon for each part that hangs together by the sides of cells, its outer ring
/// first. Rings are simple; straight vertices are left out.
std::vector<std::vector<std::vector<Point>>> cell_polygons(const Field& field,
                                                           const std::vector<std::size_t>& cells);

}  // namespace mapwright::converter
