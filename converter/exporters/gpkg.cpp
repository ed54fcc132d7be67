// GeoPackage: one file, a layer a kind.
#include "converter/exporters/gis/placed_layers.hpp"
#include "converter/gdal/vector_writer.hpp"

namespace mapwright::converter {

Result<Exported> export_gpkg(const ExportJob& job) {
  auto placed = placed_layers(job, job.georeference ? usual_crs(*job.georeference) : "");
  if (!placed) return tl::unexpected(placed.error());
  const std::string name = job.stem + ".gpkg";
  auto written =
      write_layers(placed->layers, {job.folder + "/" + name, "GPKG", placed->crs, {}, 0});
  if (!written) return tl::unexpected(written.error());
  return Exported{{name}, std::move(placed->warnings)};
}

}  // namespace mapwright::converter
