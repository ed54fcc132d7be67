// KML: a folder a kind, shapes extruded to their heights above the ground.
#include <fstream>

#include "converter/exchange/decimal_text.hpp"
#include "converter/exchange/fields.hpp"
#include "converter/exporters/gis/placed_layers.hpp"

namespace mapwright::converter {
namespace {

std::string escaped(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\t')
      xml += c;  // XML knows no other control characters
  }
  return xml;
}

std::string plain_text(const FieldValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) return shortest_decimal(*real);
  return std::get<std::string>(value);
}

class KmlWriter {
 public:
  explicit KmlWriter(std::ostream& out) : out_(out) {}

  void write(const std::vector<GisLayer>& layers, const std::string& name) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<name>"
         << escaped(name) << "</name>\n"
         << "<Style id=\"map\"><LineStyle><color>ff404040</color><width>2</width></LineStyle>"
            "<PolyStyle><color>b0b0c8d8</color></PolyStyle></Style>\n"
            "<Style id=\"border\"><LineStyle><color>ff0000ff</color></LineStyle>"
            "<PolyStyle><fill>0</fill></PolyStyle></Style>\n";
    for (const auto& layer : layers) {
      if (!layer.features.empty()) write_layer(layer);
    }
    out_ << "</Document>\n</kml>\n";
  }

 private:
  void write_layer(const GisLayer& layer) {
    out_ << "<Folder><name>" << layer.name << "</name>\n";
    names_.clear();
    for (const auto& column : layer.columns) names_.push_back(column.name);
    const bool is_border = layer.name == kBorderShape;
    for (const auto& feature : layer.features) write_feature(feature, is_border);
    out_ << "</Folder>\n";
  }

  void write_feature(const GisFeature& feature, bool is_border) {
    out_ << "<Placemark><name>" << escaped(name_of(feature)) << "</name><styleUrl>"
         << (is_border ? "#border" : "#map") << "</styleUrl>\n<ExtendedData>";
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (is_null(feature.values[i]) || names_[i] == semantic_key::kName) continue;
      out_ << "<Data name=\"" << names_[i] << "\"><value>" << escaped(plain_text(feature.values[i]))
           << "</value></Data>";
    }
    out_ << "</ExtendedData>\n";
    write_geometry(feature, is_border);
    out_ << "</Placemark>\n";
  }

  // KML's own name is the token's: a field of that name would be its double.
  std::string name_of(const GisFeature& feature) const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const bool is_name = names_[i] == semantic_key::kName && !is_null(feature.values[i]);
      if (is_name) return plain_text(feature.values[i]);
    }
    return {};
  }

  void write_geometry(const GisFeature& feature, bool is_border) {
    const std::string height = is_border ? "0" : shortest_decimal(feature.height_m);
    const std::string mode = is_border ? "<altitudeMode>clampToGround</altitudeMode>"
                                       : "<extrude>1</extrude><altitudeMode>relativeToGround"
                                         "</altitudeMode>";
    if (feature.geometry == GisGeometry::kLine) {
      out_ << "<LineString>" << mode;
      write_path(feature.paths.front(), height, false);
      out_ << "</LineString>";
    }
    if (feature.geometry != GisGeometry::kPolygon) return;
    out_ << "<Polygon>" << mode;
    for (std::size_t i = 0; i < feature.paths.size(); ++i) {
      const char* boundary = i == 0 ? "outerBoundaryIs" : "innerBoundaryIs";
      out_ << "<" << boundary << "><LinearRing>";
      write_path(feature.paths[i], height, true);
      out_ << "</LinearRing></" << boundary << ">";
    }
    out_ << "</Polygon>";
  }

  void write_path(const std::vector<Point>& path, const std::string& height, bool close) {
    out_ << "<coordinates>";
    const auto write = [&](Point p) {
      out_ << shortest_decimal(p.x) << ',' << shortest_decimal(p.y) << ',' << height << ' ';
    };
    for (const Point p : path) write(p);
    if (close) write(path.front());
    out_ << "</coordinates>";
  }

  std::ostream& out_;
  std::vector<std::string> names_;
};

}  // namespace

Result<Exported> export_kml(const ExportJob& job) {
  if (!job.georeference) {
    return usage_failure(
        "KML is in longitude and latitude, and the map has no georeference (no sidecar beside it)");
  }
  if (!job.crs.empty() && job.crs != kWgs84) {
    return usage_failure("--crs: KML is always in longitude and latitude");
  }
  ExportJob asked = job;
  asked.crs = kWgs84;
  auto placed = placed_layers(asked, kWgs84);
  if (!placed) return tl::unexpected(placed.error());
  const std::string name = job.stem + ".kml";
  std::ofstream out(job.folder + "/" + name, std::ios::binary);
  KmlWriter(out).write(placed->layers, job.stem);
  out.close();
  if (!out) return output_failure(name + ": cannot be written to its end");
  return Exported{{name}, std::move(placed->warnings)};
}

}  // namespace mapwright::converter
