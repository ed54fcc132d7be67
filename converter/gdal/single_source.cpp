#include "converter/gdal/single_source.hpp"

#include "converter/gdal/csv_reader.hpp"
#include "converter/gdal/dxf_reader.hpp"
#include "converter/gdal/geojson_reader.hpp"
#include "converter/gdal/gml_features.hpp"
#include "converter/gdal/kml_features.hpp"
#include "converter/gdal/xml_coordinates.hpp"
#include "converter/indoorgml/indoorgml_reader.hpp"
#include "converter/osm/osm_reader.hpp"

namespace mapwright::converter {

OpenedReader open_single(const GdalInput& input, const DriverNotice& notice) {
  if (is_osm(input.path)) {
    notice("OSM");
    return open_osm(input.path);
  }
  if (is_indoorgml(input.path)) {
    notice("IndoorGML");
    return open_indoorgml(input.path);
  }
  if (is_csv(input.path)) return open_csv(input, notice);
  if (is_dxf(input.path)) return open_dxf(input, notice);
  auto reader = open_gdal(input, notice);
  if (!reader) return reader;
  const auto& driver = (*reader)->driver();
  if (driver == "GeoJSON") return with_checked_shapes(*std::move(reader), input.path);
  if (driver == "LIBKML" || driver == "KML" || driver == "GML") {
    if (const auto word = word_among_coordinates(input.path)) {
      return input_failure(input.title + ": cannot be read: " + *word);
    }
  }
  if (driver == "LIBKML") return with_told_elements(*std::move(reader), input.path, input.title);
  if (driver == "GML") return with_told_geometries(*std::move(reader), input.path);
  return reader;
}

}  // namespace mapwright::converter
