// A field as a GeoTIFF.
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "converter/exporters/field.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/frame/local_frame.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

constexpr int kMostPixels = 1 << 30;

Failure cannot_write(const std::string& path, const GdalMessages& messages) {
  return {FailureKind::kOutput, std::filesystem::path(path).filename().string() +
                                    ": the raster cannot be written" +
                                    (messages.has_error() ? ": " + messages.first_error() : "")};
}

Georeference upright(Georeference georeference) {
  georeference.heading_deg = 0.0;
  georeference.projection = FrameProjection::kTransverseMercator;
  return georeference;
}

/// From columns and rows of pixels to coordinates, as GDAL has it.
using GeoTransform = std::array<double, 6>;

GeoTransform transform_of(const Field& field, const std::optional<Georeference>& georeference) {
  const double height_m = field.cell_m * static_cast<double>(field.rows);
  const Point corner{field.corner.x, field.corner.y + height_m};
  if (!georeference) return {corner.x, field.cell_m, 0.0, corner.y, 0.0, -field.cell_m};
  const LocalFrame from(*georeference);
  const LocalFrame to(upright(*georeference));
  const auto placed = [&](Point p) { return to.to_map(from.to_wgs84(p)); };
  const double width_m = field.cell_m * static_cast<double>(field.columns);
  const Point at = placed(corner);
  const Point right =
      (1.0 / static_cast<double>(field.columns)) * (placed(corner + Point{width_m, 0.0}) - at);
  const Point down = (1.0 / static_cast<double>(field.rows)) * (placed(field.corner) - at);
  return {at.x, right.x, down.x, at.y, right.y, down.y};
}

bool write_band(GDALRasterBand& band, const Field& field, const FieldBand& values) {
  band.SetDescription(values.name.c_str());
  band.SetMetadataItem("DESCRIPTION", values.what.c_str());
  if (band.SetNoDataValue(kNoData) != CE_None) return false;
  std::vector<float> line(field.columns);
  for (std::size_t row = 0; row < field.rows; ++row) {
    const float* from = values.values.data() + (field.rows - 1 - row) * field.columns;
    for (std::size_t i = 0; i < line.size(); ++i) line[i] = std::isnan(from[i]) ? kNoData : from[i];
    if (band.RasterIO(GF_Write, 0, static_cast<int>(row), static_cast<int>(line.size()), 1,
                      line.data(), static_cast<int>(line.size()), 1, GDT_Float32, 0, 0,
                      nullptr) != CE_None) {
      return false;
    }
  }
  return true;
}

bool write_all(GDALDataset& dataset, const Field& field,
               const std::optional<Georeference>& georeference) {
  GeoTransform transform = transform_of(field, georeference);
  if (dataset.SetGeoTransform(transform.data()) != CE_None) return false;
  if (georeference) {
    OGRSpatialReference reference;
    reference.importFromWkt(frame_wkt2(upright(*georeference)).c_str());
    if (dataset.SetSpatialRef(&reference) != CE_None) return false;
  }
  for (std::size_t i = 0; i < field.bands.size(); ++i) {
    if (!write_band(*dataset.GetRasterBand(static_cast<int>(i) + 1), field, field.bands[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

Result<void> write_field_geotiff(const Field& field,
                                 const std::optional<Georeference>& georeference,
                                 const std::string& path) {
  if (field.columns > kMostPixels || field.rows > kMostPixels) {
    return output_failure("the raster has too many pixels a side; choose larger cells");
  }
  GdalMessages messages;
  GDALRegister_GTiff();
  auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  char* options[] = {const_cast<char*>("COMPRESS=DEFLATE"), const_cast<char*>("PREDICTOR=3"),
                     const_cast<char*>("INTERLEAVE=BAND"), nullptr};
  GDALDatasetUniquePtr dataset(
      driver->Create(path.c_str(), static_cast<int>(field.columns), static_cast<int>(field.rows),
                     static_cast<int>(field.bands.size()), GDT_Float32, options));
  if (!dataset || !write_all(*dataset, field, georeference)) {
    return tl::unexpected(cannot_write(path, messages));
  }
  dataset.reset();
  if (messages.has_error()) return tl::unexpected(cannot_write(path, messages));
  return {};
}

}  // namespace mapwright::converter
