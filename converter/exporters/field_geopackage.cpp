// A field as a GeoPackage: cells and areas with attributes.
#include <cmath>

#include "converter/exporters/field.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/gdal/vector_writer.hpp"

namespace mapwright::converter {
namespace {

std::vector<Point> square(const Field& field, std::size_t i) {
  const double x = field.corner.x + field.cell_m * static_cast<double>(i % field.columns);
  const double y = field.corner.y + field.cell_m * static_cast<double>(i / field.columns);
  return {
      {x, y}, {x + field.cell_m, y}, {x + field.cell_m, y + field.cell_m}, {x, y + field.cell_m}};
}

GisLayer cells_of(const Field& field) {
  GisLayer layer{"cells", GisGeometry::kPolygon, {}, {}};
  for (const auto& band : field.bands) layer.columns.push_back({band.name, GisType::kReal});
  for (std::size_t i = 0; i < field.columns * field.rows; ++i) {
    GisFeature feature{GisGeometry::kPolygon, {}, {}, 0.0};
    bool any = false;
    for (const auto& band : field.bands) {
      const float value = band.values[i];
      const bool known = !std::isnan(value);
      any = any || known;
      if (known) {
        feature.values.emplace_back(static_cast<double>(value));
      } else {
        feature.values.emplace_back();
      }
    }
    if (!any) continue;
    feature.paths.push_back(square(field, i));
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

}  // namespace

Result<void> write_field_geopackage(const Field& field, const std::vector<GisLayer>& layers,
                                    const std::optional<Georeference>& georeference,
                                    const std::string& path) {
  std::vector<GisLayer> all{cells_of(field)};
  all.insert(all.end(), layers.begin(), layers.end());
  return write_layers(all, {path, "GPKG", georeference ? frame_wkt2(*georeference) : "", {}, 0});
}

}  // namespace mapwright::converter
