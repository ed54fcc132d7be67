// FlatGeobuf: one layer of everything, with a spatial index.
#include "converter/exporters/gis/placed_layers.hpp"
#include "converter/gdal/vector_writer.hpp"

namespace mapwright::converter {
Result<Exported> export_fgb(const ExportJob& job) {
  auto placed = placed_layers(job, job.georeference ? usual_crs(*job.georeference) : "");
  if (!placed) return tl::unexpected(placed.error());
  const std::string name = job.stem + ".fgb";
  for (auto& warning : warning_of_empty(placed->layers, "FlatGeobuf")) {
    placed->warnings.push_back(std::move(warning));
  }
  const auto layer = in_one_layer(std::move(placed->layers), job.stem);
  auto written = write_layers(
      {layer}, {job.folder + "/" + name, "FlatGeobuf", placed->crs, {"SPATIAL_INDEX=YES"}, 0});
  if (!written) return tl::unexpected(written.error());
  return Exported{{name}, std::move(placed->warnings)};
}

}  // namespace mapwright::converter
