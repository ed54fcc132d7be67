#include "converter/authoring/site_template.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "converter/authoring/template_layers.hpp"
#include "converter/authoring/template_style.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/frame/local_frame.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

// Written where a GeoPackage keeps the time of its last change.
constexpr const char* kNoDate = "2000-01-01T00:00:00.000Z";

OGRFieldType ogr_type(FieldType type) {
  switch (type) {
    case FieldType::kText:
      return OFTString;
    case FieldType::kReal:
      return OFTReal;
    case FieldType::kInteger:
      return OFTInteger;
  }
  return OFTString;
}

std::string text_of(std::string_view view) {
  return std::string(view);
}

class TemplateWriter {
 public:
  TemplateWriter(GDALDataset& dataset, const SiteTemplate& site) : dataset_(dataset), site_(site) {}

  Result<void> write() {
    if (auto placed = place(); !placed) return placed;
    for (const auto* domain : template_domains()) add_domain(*domain);
    for (const auto& layer : template_layers()) {
      if (!add_layer(layer)) return failure();
    }
    return add_border() && add_styles() ? Result<void>() : failure();
  }

 private:
  tl::unexpected<Failure> failure() const {
    return output_failure("the template cannot be written: " + messages_.first_error());
  }

  // Where the layers are drawn.
  Result<void> place() {
    Georeference upright = site_.georeference;
    upright.heading_deg = 0.0;
    upright.projection = FrameProjection::kTransverseMercator;
    const std::string wkt = site_.crs.is_stated() ? site_.crs.wkt : frame_wkt2(upright);
    reference_.importFromWkt(wkt.c_str());
    reference_.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    Crs crs = site_.crs;
    crs.wkt = wkt;
    auto transform = CrsTransform::create(crs);
    if (!transform) return tl::unexpected(transform.error());
    return place_corners(*transform);
  }

  Result<void> place_corners(const CrsTransform& transform) {
    const LocalFrame frame(site_.georeference);
    const double x = 0.5 * site_.width_m, y = 0.5 * site_.height_m;
    const std::array<Point, 4> corners{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const GeoPoint place = frame.to_wgs84(corners[i]);
      xs_[i] = place.longitude_deg;
      ys_[i] = place.latitude_deg;
    }
    transform.from_wgs84(xs_, ys_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (std::isfinite(xs_[i]) && std::isfinite(ys_[i])) continue;
      return input_failure(site_.crs.title() + " has no coordinates for a place at the origin");
    }
    return {};
  }

  void add_domain(const FieldDomain& domain) {
    const auto name = text_of(domain.name), description = text_of(domain.description);
    std::string problem;
    std::unique_ptr<OGRFieldDomain> made;
    if (domain.values.empty()) {
      OGRField least, most;
      set_limit(least, domain.type, domain.least);
      set_limit(most, domain.type, domain.most);
      made = std::make_unique<OGRRangeFieldDomain>(name, description, ogr_type(domain.type),
                                                   OFSTNone, least, true, most, true);
    } else {
      made = std::make_unique<OGRCodedFieldDomain>(name, description, ogr_type(domain.type),
                                                   OFSTNone, coded_values(domain));
    }
    dataset_.AddFieldDomain(std::move(made), problem);
  }

  static void set_limit(OGRField& limit, FieldType type, double value) {
    if (type == FieldType::kInteger)
      limit.Integer = static_cast<int>(value);
    else
      limit.Real = value;
  }

  // The domain frees them.
  static std::vector<OGRCodedValue> coded_values(const FieldDomain& domain) {
    std::vector<OGRCodedValue> values;
    for (const auto& listed : domain.values) {
      values.push_back(
          {CPLStrdup(text_of(listed.value).c_str()), CPLStrdup(text_of(listed.label).c_str())});
    }
    return values;
  }

  bool add_layer(const TemplateLayer& layer) {
    CPLStringList options;
    options.SetNameValue("GEOMETRY_NAME", "geom");
    options.SetNameValue("FID", "fid");
    options.SetNameValue("DESCRIPTION", text_of(layer.description).c_str());
    const auto type = layer.geometry == TemplateGeometry::kPolygon ? wkbPolygon : wkbLineString;
    auto* made = dataset_.CreateLayer(text_of(layer.name).c_str(), &reference_, type, options);
    if (made == nullptr) return false;
    for (const auto& field : layer.fields) {
      if (!add_field(*made, field)) return false;
    }
    return true;
  }

  static bool add_field(OGRLayer& layer, const TemplateField& field) {
    OGRFieldDefn definition(text_of(field.name).c_str(), ogr_type(field.type));
    definition.SetAlternativeName(text_of(field.label).c_str());
    if (field.domain != nullptr) definition.SetDomainName(text_of(field.domain->name));
    if (!field.initial.empty()) {
      const auto initial = text_of(field.initial);
      definition.SetDefault(field.type == FieldType::kText ? ("'" + initial + "'").c_str()
                                                           : initial.c_str());
    }
    return layer.CreateField(&definition) == OGRERR_NONE;
  }

  bool add_border() {
    auto* layer = dataset_.GetLayerByName(text_of(template_layers().front().name).c_str());
    OGRFeature feature(layer->GetLayerDefn());
    OGRLinearRing ring;
    for (std::size_t i = 0; i <= xs_.size(); ++i) ring.addPoint(xs_[i % 4], ys_[i % 4]);
    OGRPolygon polygon;
    polygon.addRing(&ring);
    feature.SetGeometry(&polygon);
    const auto& g = site_.georeference;
    feature.SetField("mapwright", 1);
    feature.SetField("frame", text_of(to_string(g.projection)).c_str());
    feature.SetField("origin_lat", g.origin_latitude_deg);
    feature.SetField("origin_lon", g.origin_longitude_deg);
    feature.SetField("origin_h", g.origin_height_m);
    feature.SetField("heading", g.heading_deg);
    feature.SetField("resolution", site_.resolution_m);
    return layer->CreateFeature(&feature) == OGRERR_NONE;
  }

  // The table that QGIS looks for styles in.
  bool add_styles() {
    CPLStringList options;
    options.SetNameValue("FID", "id");
    auto* table = dataset_.CreateLayer("layer_styles", nullptr, wkbNone, options);
    if (table == nullptr) return false;
    for (const char* name : {"f_table_catalog", "f_table_schema", "f_table_name",
                             "f_geometry_column", "styleName", "styleQML", "styleSLD"}) {
      OGRFieldDefn field(name, OFTString);
      if (table->CreateField(&field) != OGRERR_NONE) return false;
    }
    OGRFieldDefn is_default("useAsDefault", OFTInteger);
    is_default.SetSubType(OFSTBoolean);
    OGRFieldDefn description("description", OFTString), owner("owner", OFTString);
    OGRFieldDefn ui("ui", OFTString), updated("update_time", OFTDateTime);
    for (auto* field : {&is_default, &description, &owner, &ui, &updated}) {
      if (table->CreateField(field) != OGRERR_NONE) return false;
    }
    for (const auto& layer : template_layers()) {
      if (!add_style(*table, layer)) return false;
    }
    return true;
  }

  static bool add_style(OGRLayer& table, const TemplateLayer& layer) {
    OGRFeature row(table.GetLayerDefn());
    for (const char* name : {"f_table_catalog", "f_table_schema", "styleSLD", "owner", "ui"}) {
      row.SetField(name, "");
    }
    row.SetField("f_table_name", text_of(layer.name).c_str());
    row.SetField("f_geometry_column", "geom");
    row.SetField("styleName", text_of(layer.name).c_str());
    row.SetField("styleQML", template_style(layer).c_str());
    row.SetField("useAsDefault", 1);
    row.SetField("description", text_of(layer.description).c_str());
    row.SetField("update_time", kNoDate);
    return table.CreateFeature(&row) == OGRERR_NONE;
  }

  GDALDataset& dataset_;
  const SiteTemplate& site_;
  GdalMessages messages_;
  OGRSpatialReference reference_;
  std::array<double, 4> xs_{}, ys_{};
};

}  // namespace

Result<void> write_site_template(const std::string& path, const SiteTemplate& site) {
  if (const auto drivers = allow_drivers({}); !drivers) return tl::unexpected(drivers.error());
  const GdalMessages messages;
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", kNoDate, false);
  auto* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) return output_failure(path + ": this GDAL writes no GeoPackage");
  const std::unique_ptr<GDALDataset> dataset(
      driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) return output_failure(path + ": cannot be created: " + messages.first_error());
  return TemplateWriter(*dataset, site).write();
}

}  // namespace mapwright::converter
