// Shapefiles: polygons in the file that is named, lines in another beside it.
#include <filesystem>

#include "converter/exchange/fields.hpp"
#include "converter/exporters/gis/placed_layers.hpp"
#include "converter/gdal/vector_writer.hpp"

namespace mapwright::converter {
namespace {

// dBase keeps no longer text in a field.
constexpr std::size_t kMostTextBytes = 254;

Result<void> write_shapefile(GisLayer layer, const std::string& crs, const std::string& folder,
                             const std::string& stem, std::vector<std::string>& files) {
  layer.name = stem;
  auto written = write_layers(
      {layer},
      {folder + "/" + stem + ".shp", "ESRI Shapefile", crs, {"ENCODING=UTF-8"}, kMostTextBytes});
  if (!written) return written;
  for (const char* extension : {".shp", ".shx", ".dbf", ".prj", ".cpg"}) {
    std::error_code error;
    const std::string path = folder + "/" + stem + extension;
    // A turned frame has no WKT 1: its .prj would be empty.
    const auto size = std::filesystem::file_size(path, error);
    if (!error && size > 0) files.push_back(stem + extension);
  }
  return {};
}

}  // namespace

Result<Exported> export_shp(const ExportJob& job) {
  auto placed = placed_layers(job, job.georeference ? usual_crs(*job.georeference) : "");
  if (!placed) return tl::unexpected(placed.error());
  Exported exported;
  exported.warnings = std::move(placed->warnings);
  auto layers = by_geometry(std::move(placed->layers));
  for (auto& layer : layers) {
    const bool lines = layer.geometry == GisGeometry::kLine;
    const std::string stem = lines ? job.stem + std::string(kLinesSuffix) : job.stem;
    auto written = write_shapefile(std::move(layer), placed->crs, job.folder, stem, exported.files);
    if (!written) return tl::unexpected(written.error());
  }
  return exported;
}

}  // namespace mapwright::converter
