#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <atomic>
#include <memory>

#include "converter/exporters/findings/finding_rows.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

// What GeoPackage calls undefined Cartesian coordinates; GDAL knows it by this name.
constexpr const char* kMetresWkt = "LOCAL_CS[\"Undefined Cartesian SRS\",UNIT[\"metre\",1]]";

struct PartLayer {
  FindingPart part;
  const char* name;
  OGRwkbGeometryType type;
};
constexpr std::array<PartLayer, 3> kLayers{
    {{FindingPart::kPoints, "findings", wkbMultiPoint},
     {FindingPart::kLines, "finding_lines", wkbMultiLineString},
     {FindingPart::kAreas, "finding_areas", wkbMultiPolygon}}};

/// A file in memory that vanishes with the object.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<unsigned> count{0};
    name_ = "/vsimem/mapwright_findings_" + std::to_string(count++) + ".gpkg";
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name_.c_str()); }

  const std::string& name() const { return name_; }

  std::string content() const {
    vsi_l_offset size = 0;
    const GByte* const bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    if (bytes == nullptr) return {};
    return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }

 private:
  std::string name_;
};

/// A GeoPackage says when it was written; the same findings are to give the same bytes.
class FixedDate {
 public:
  FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z"); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
  ~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
};

OGRSpatialReference srs_of(const std::vector<MapFindings>& maps, FindingFrame frame) {
  OGRSpatialReference srs;
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (frame == FindingFrame::kWgs84) srs.importFromEPSG(4326);
  if (frame == FindingFrame::kMetres) srs.importFromWkt(kMetresWkt);
  if (frame == FindingFrame::kMapFrame) {
    for (const auto& map : maps) {
      if (!map.georeference) continue;
      srs.importFromWkt(frame_wkt2(*map.georeference).c_str());
      break;
    }
  }
  return srs;
}

void append(OGRSimpleCurve& curve, const std::vector<Point>& path) {
  for (const Point p : path) curve.addPoint(p.x, p.y);
}

std::unique_ptr<OGRGeometry> part_of(FindingPart part, const std::vector<Point>& path) {
  if (part == FindingPart::kPoints) {
    return std::make_unique<OGRPoint>(path.front().x, path.front().y);
  }
  if (part == FindingPart::kLines) {
    auto line = std::make_unique<OGRLineString>();
    append(*line, path);
    return line;
  }
  auto ring = std::make_unique<OGRLinearRing>();
  append(*ring, path);
  auto polygon = std::make_unique<OGRPolygon>();
  polygon->addRingDirectly(ring.release());
  return polygon;
}

void set_geometry(OGRFeature& feature, const FindingRow& row, OGRwkbGeometryType type) {
  if (row.paths.empty()) return;
  std::unique_ptr<OGRGeometry> geometry(OGRGeometryFactory::createGeometry(type));
  for (const auto& path : row.paths) {
    geometry->toGeometryCollection()->addGeometryDirectly(part_of(row.part, path).release());
  }
  feature.SetGeometryDirectly(geometry.release());
}

void set_field(OGRFeature& feature, int field, const FindingValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    feature.SetField(field, static_cast<GIntBig>(*number));
  } else if (const auto* real = std::get_if<double>(&value)) {
    feature.SetField(field, *real);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    feature.SetField(field, text->c_str());
  } else {
    feature.SetFieldNull(field);
  }
}

OGRFieldType field_type(FindingColumn::Type type) {
  switch (type) {
    case FindingColumn::Type::kInteger:
      return OFTInteger64;
    case FindingColumn::Type::kReal:
      return OFTReal;
    case FindingColumn::Type::kText:
      return OFTString;
  }
  return OFTString;
}

bool create_fields(OGRLayer& layer) {
  for (const auto& column : kFindingColumns) {
    OGRFieldDefn field(std::string(column.name).c_str(), field_type(column.type));
    if (layer.CreateField(&field) != OGRERR_NONE) return false;
  }
  return true;
}

bool write_row(OGRLayer& layer, const FindingRow& row, OGRwkbGeometryType type) {
  OGRFeature feature(layer.GetLayerDefn());
  const auto values = values_of(row);
  for (std::size_t i = 0; i < values.size(); ++i) {
    set_field(feature, static_cast<int>(i), values[i]);
  }
  set_geometry(feature, row, type);
  return layer.CreateFeature(&feature) == OGRERR_NONE;
}

bool write_layer(GDALDataset& dataset, const PartLayer& part, OGRSpatialReference& srs,
                 const std::vector<FindingRow>& rows, GdalMessages& messages) {
  OGRLayer* const layer = dataset.CreateLayer(part.name, &srs, part.type, nullptr);
  if (layer == nullptr) return false;
  // A derived projected CRS has a form in WKT2 only. GDAL complains of the older form it tries
  // first, and writes the new one.
  messages.clear_error();
  if (!create_fields(*layer)) return false;
  for (const auto& row : rows) {
    if (row.part == part.part && !write_row(*layer, row, part.type)) return false;
  }
  return true;
}

bool write_all(const std::string& name, const std::vector<MapFindings>& maps,
               GdalMessages& messages) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (driver == nullptr) return false;
  GDALDatasetUniquePtr dataset(driver->Create(name.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset || dataset->StartTransaction() != OGRERR_NONE) return false;
  const FindingFrame frame = frame_of(maps, false);
  OGRSpatialReference srs = srs_of(maps, frame);
  const auto rows = finding_rows(maps, frame);
  for (const auto& layer : kLayers) {
    if (!write_layer(*dataset, layer, srs, rows, messages)) return false;
  }
  return dataset->CommitTransaction() == OGRERR_NONE;
}

}  // namespace

Result<std::string> findings_geopackage(const std::vector<MapFindings>& maps) {
  GDALAllRegister();
  const FixedDate date;
  GdalMessages messages;
  const MemoryFile file;
  if (!write_all(file.name(), maps, messages) || messages.has_error()) {
    return output_failure("the GeoPackage of findings: " + messages.first_error());
  }
  return file.content();
}

}  // namespace mapwright::converter
