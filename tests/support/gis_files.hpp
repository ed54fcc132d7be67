// GIS files made by tests.
#pragma once

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace mapwright::test {

/// A feature: geometry as WKT (empty: none) and attributes as text.
struct GisFeature {
  std::string wkt;
  std::map<std::string, std::string> attributes;
  int vertex_not_a_number = -1;  ///< of a line; WKT cannot say it
};

struct GisLayer {
  std::string name;
  std::string crs;  ///< "EPSG:25831"; empty: none
  std::vector<GisFeature> features;
  OGRwkbGeometryType type = wkbUnknown;
};

/// A number becomes a real field, anything else a text field.
inline OGRFieldType field_type(const std::string& value) {
  const bool number =
      value.find_first_not_of("0123456789.-") == std::string::npos && !value.empty();
  return number ? OFTReal : OFTString;
}

inline void write_layer(GDALDataset& dataset, const GisLayer& layer) {
  OGRSpatialReference crs;
  if (!layer.crs.empty()) {
    ASSERT_EQ(crs.SetFromUserInput(layer.crs.c_str()), OGRERR_NONE);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  }
  auto* target =
      dataset.CreateLayer(layer.name.c_str(), layer.crs.empty() ? nullptr : &crs, layer.type);
  ASSERT_NE(target, nullptr);
  std::map<std::string, OGRFieldType> fields;
  for (const auto& feature : layer.features) {
    for (const auto& [name, value] : feature.attributes) {
      const auto known = fields.emplace(name, field_type(value)).first;
      if (field_type(value) == OFTString) known->second = OFTString;
    }
  }
  for (const auto& [name, type] : fields) {
    OGRFieldDefn field(name.c_str(), type);
    ASSERT_EQ(target->CreateField(&field), OGRERR_NONE);
  }
  for (const auto& feature : layer.features) {
    OGRFeature row(target->GetLayerDefn());
    for (const auto& [name, value] : feature.attributes) row.SetField(name.c_str(), value.c_str());
    if (!feature.wkt.empty()) {
      OGRGeometry* geometry = nullptr;
      ASSERT_EQ(OGRGeometryFactory::createFromWkt(feature.wkt.c_str(), nullptr, &geometry),
                OGRERR_NONE)
          << feature.wkt;
      if (feature.vertex_not_a_number >= 0) {
        geometry->toLineString()->setPoint(feature.vertex_not_a_number, NAN, NAN);
      }
      row.SetGeometryDirectly(geometry);
    }
    ASSERT_EQ(target->CreateFeature(&row), OGRERR_NONE);
  }
}

/// Writes layers with a driver of GDAL: "GPKG" (one file), "ESRI Shapefile" (a folder, or a file
/// for one layer), "GeoJSON" (one layer).
inline void write_gis(const std::string& path, const std::string& driver,
                      const std::vector<GisLayer>& layers) {
  RegisterOGRShape();
  RegisterOGRGeoPackage();
  RegisterOGRGeoJSON();
  auto* maker = GetGDALDriverManager()->GetDriverByName(driver.c_str());
  ASSERT_NE(maker, nullptr);
  const GDALDatasetUniquePtr dataset(maker->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_NE(dataset, nullptr) << path;
  for (const auto& layer : layers) write_layer(*dataset, layer);
}

}  // namespace mapwright::test
