// Private to the exporters: layers in the CRS they shall be written in.
#pragma once

#include <string>
#include <vector>

#include "converter/exporters/export_map.hpp"
#include "converter/exporters/gis/gis_layers.hpp"

namespace mapwright::converter {

struct PlacedLayers {
  std::vector<GisLayer> layers;
  std::string crs;  ///< WKT of their coordinates; empty for a map without a place on Earth
  std::vector<std::string> warnings;
};

/// CRS of the sources that a sidecar names, where all agree; else longitude and latitude.
std::string usual_crs(const Georeference& georeference);

/// Longitude and latitude on WGS 84.
inline constexpr const char* kWgs84 = "EPSG:4326";

/// Layers of the map in the CRS the job asks for, or in `usual` ("map" or as `parse_crs` reads it).
/// A map without georeference stays in metres of its frame, which a warning says. Where `usual`
/// cannot hold the map's resolution, it stays in metres of its frame too; a CRS asked for fails.
Result<PlacedLayers> placed_layers(const ExportJob& job, const std::string& usual,
                                   bool join_holes = true);

/// Features without geometry, which stand for obstacles without segments.
std::size_t count_without_geometry(const std::vector<GisLayer>& layers);

/// What an exporter says of them whose format drops them; empty for none.
std::vector<std::string> warning_of_empty(const std::vector<GisLayer>& layers,
                                          const std::string& format);

}  // namespace mapwright::converter
