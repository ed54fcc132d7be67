// GeoJSON: one collection of everything, in longitude and latitude as RFC 7946 wants it.
#include "converter/exporters/gis/placed_layers.hpp"
#include "converter/gdal/vector_writer.hpp"

namespace mapwright::converter {

Result<Exported> export_geojson(const ExportJob& job) {
  auto placed = placed_layers(job, kWgs84);
  if (!placed) return tl::unexpected(placed.error());
  const std::string name = job.stem + ".geojson";
  const auto layer = in_one_layer(std::move(placed->layers), job.stem);
  auto written = write_layers(
      {layer}, {job.folder + "/" + name, "GeoJSON", placed->crs, {"COORDINATE_PRECISION=15"}, 0});
  if (!written) return tl::unexpected(written.error());
  return Exported{{name}, std::move(placed->warnings)};
}

}  // namespace mapwright::converter
