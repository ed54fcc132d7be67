#include "converter/gdal/vector_writer.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <filesystem>

#include "converter/exchange/fields.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

constexpr const char* kLocalMetres =
    R"(ENGCRS["mapwright map frame, local metres",EDATUM["the map's origin"],CS[Cartesian,2],)"
    R"(AXIS["x",east,ORDER[1]],AXIS["y",north,ORDER[2]],LENGTHUNIT["metre",1]])";

OGRSpatialReference reference_of(const std::string& crs) {
  OGRSpatialReference reference;
  if (crs.empty())
    reference.importFromWkt(kLocalMetres);
  else
    reference.SetFromUserInput(crs.c_str(),
                               OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

OGRFieldType field_type(GisType type) {
  if (type == GisType::kInteger) return OFTInteger64;
  return type == GisType::kReal ? OFTReal : OFTString;
}

// Where a text may be cut: between characters, no blank at either side (dBase drops those).
std::size_t cut_before(const std::string& text, std::size_t begin, std::size_t most) {
  if (text.size() - begin <= most) return text.size();
  const auto may_cut = [&](std::size_t at) {
    const bool within_character = (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    return !within_character && text[at] != ' ' && text[at - 1] != ' ';
  };
  for (std::size_t at = begin + most; at > begin + most / 2; --at) {
    if (may_cut(at)) return at;
  }
  return begin + most;
}

std::vector<std::string> pieces_of(const std::string& text, std::size_t most) {
  std::vector<std::string> pieces;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = most == 0 ? text.size() : cut_before(text, begin, most);
    pieces.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return pieces;
}

// A turned frame can be said in WKT 2 only; drivers try the old one first.
bool is_about_old_wkt(const std::string& error) {
  return error.find("can only be exported to WKT2") != error.npos;
}

// Whether what a driver says while writing means that something is not written as it should be.
bool is_harmless(const std::string& warning) {
  return warning.find("Normalized/laundered field name") != warning.npos ||
         is_about_old_wkt(warning);
}

class LayerWriter {
 public:
  LayerWriter(const GisLayer& layer, OGRLayer& target, const WriteTarget& options)
      : layer_(layer),
        target_(target),
        most_(options.most_text_bytes) {}

  bool create_fields() {
    for (std::size_t i = 0; i < layer_.columns.size(); ++i) {
      first_field_.push_back(target_.GetLayerDefn()->GetFieldCount());
      if (!create_field(layer_.columns[i].name, i)) return false;
      for (int number = 2; number <= pieces_in(i); ++number) {
        if (!create_field(continued_field(layer_.columns[i].name, number), i)) return false;
      }
    }
    return true;
  }

  bool write(const GisFeature& from) {
    OGRFeature feature(target_.GetLayerDefn());
    for (std::size_t i = 0; i < from.values.size(); ++i) set_value(feature, i, from.values[i]);
    if (from.geometry == GisGeometry::kLine) feature.SetGeometryDirectly(line(from).release());
    if (from.geometry == GisGeometry::kPolygon) {
      feature.SetGeometryDirectly(polygon(from).release());
    }
    return target_.CreateFeature(&feature) == OGRERR_NONE;
  }

 private:
  bool create_field(const std::string& name, std::size_t column) {
    OGRFieldDefn definition(name.c_str(), field_type(layer_.columns[column].type));
    if (most_ > 0 && definition.GetType() == OFTString) {
      definition.SetWidth(static_cast<int>(std::max<std::size_t>(1, longest_piece(column))));
    }
    // dBase writes numbers as decimals: enough of them for angles of 1e-16 degrees.
    if (most_ > 0 && definition.GetType() == OFTReal) {
      definition.SetWidth(24);
      definition.SetPrecision(is_angle(name) ? 16 : 12);
    }
    return target_.CreateField(&definition) == OGRERR_NONE;
  }

  static bool is_angle(const std::string& name) {
    return name.rfind("origin_l", 0) == 0 || name == "heading";
  }

  std::vector<std::size_t> piece_sizes(std::size_t column) const {
    std::vector<std::size_t> sizes;
    for (const auto& feature : layer_.features) {
      const auto* text = std::get_if<std::string>(&feature.values[column]);
      if (text == nullptr) continue;
      if (text->size() <= most_) {
        sizes.resize(std::max<std::size_t>(sizes.size(), 1));
        sizes[0] = std::max(sizes[0], text->size());
        continue;
      }
      const auto pieces = pieces_of(*text, most_);
      sizes.resize(std::max(sizes.size(), pieces.size()));
      for (std::size_t i = 0; i < pieces.size(); ++i)
        sizes[i] = std::max(sizes[i], pieces[i].size());
    }
    return sizes;
  }

  int pieces_in(std::size_t column) const {
    if (most_ == 0 || layer_.columns[column].type != GisType::kText) return 1;
    return static_cast<int>(piece_sizes(column).size());
  }
  std::size_t longest_piece(std::size_t column) const {
    const auto sizes = piece_sizes(column);
    return sizes.empty() ? 1 : *std::max_element(sizes.begin(), sizes.end());
  }

  void set_value(OGRFeature& feature, std::size_t column, const FieldValue& value) const {
    int field = first_field_[column];
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      feature.SetField(field, static_cast<GIntBig>(*whole));
    } else if (const auto* real = std::get_if<double>(&value)) {
      feature.SetField(field, *real);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      if (most_ == 0 || text->size() <= most_) return feature.SetField(field, text->c_str());
      for (const auto& piece : pieces_of(*text, most_)) feature.SetField(field++, piece.c_str());
    }
  }

  static std::unique_ptr<OGRLineString> line(const GisFeature& from) {
    auto line = std::make_unique<OGRLineString>();
    append(from.paths.front(), *line);
    return line;
  }

  static std::unique_ptr<OGRPolygon> polygon(const GisFeature& from) {
    auto polygon = std::make_unique<OGRPolygon>();
    for (const auto& path : from.paths) {
      auto ring = std::make_unique<OGRLinearRing>();
      append(path, *ring);
      ring->addPoint(path.front().x, path.front().y);
      polygon->addRingDirectly(ring.release());
    }
    return polygon;
  }

  static void append(const std::vector<Point>& path, OGRSimpleCurve& curve) {
    curve.setNumPoints(static_cast<int>(path.size()), FALSE);
    for (std::size_t i = 0; i < path.size(); ++i) {
      curve.setPoint(static_cast<int>(i), path[i].x, path[i].y);
    }
  }

  const GisLayer& layer_;
  OGRLayer& target_;
  std::size_t most_;
  std::vector<int> first_field_;
};

OGRwkbGeometryType geometry_of(const GisLayer& layer) {
  bool lines = false, polygons = false;
  for (const auto& feature : layer.features) {
    lines = lines || feature.geometry == GisGeometry::kLine;
    polygons = polygons || feature.geometry == GisGeometry::kPolygon;
  }
  if (lines && polygons) return wkbUnknown;
  if (!lines && !polygons) {
    return layer.geometry == GisGeometry::kLine ? wkbLineString : wkbPolygon;
  }
  return lines ? wkbLineString : wkbPolygon;
}

Failure cannot_write(const WriteTarget& target, const GdalMessages& messages,
                     const std::string& what) {
  const auto name = std::filesystem::path(target.path).filename().string();
  return {FailureKind::kOutput, name + ": " + what + " cannot be written" +
                                    (messages.has_error() ? ": " + messages.first_error() : "")};
}

bool write_features(const GisLayer& layer, LayerWriter& writer) {
  for (const auto& feature : layer.features) {
    if (!writer.write(feature)) return false;
  }
  return true;
}

Result<void> write_layer(GDALDataset& dataset, const GisLayer& layer, const WriteTarget& target,
                         GdalMessages& messages) {
  auto reference = reference_of(target.crs);
  CPLStringList options;
  for (const auto& option : target.layer_options) options.AddString(option.c_str());
  auto* created =
      dataset.CreateLayer(layer.name.c_str(), &reference, geometry_of(layer), options.List());
  const auto failed = [&] {
    return tl::unexpected(cannot_write(target, messages, "layer " + layer.name));
  };
  if (created == nullptr) return failed();
  LayerWriter writer(layer, *created, target);
  const bool transactions = dataset.TestCapability(ODsCTransactions) != 0;
  if (!writer.create_fields()) return failed();
  if (transactions) dataset.StartTransaction();
  if (!write_features(layer, writer)) return failed();
  if (transactions && dataset.CommitTransaction() != OGRERR_NONE) return failed();
  return {};
}

}  // namespace

Result<void> write_layers(const std::vector<GisLayer>& layers, const WriteTarget& target) {
  const auto drivers = allow_drivers({});
  if (!drivers) return tl::unexpected(drivers.error());
  GdalMessages messages;
  std::error_code error;
  std::filesystem::remove(target.path, error);
  auto* driver = GetGDALDriverManager()->GetDriverByName(target.driver.c_str());
  GDALDatasetUniquePtr dataset(driver->Create(target.path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) return tl::unexpected(cannot_write(target, messages, "the file"));
  for (const auto& layer : layers) {
    if (auto written = write_layer(*dataset, layer, target, messages); !written) return written;
  }
  dataset.reset();
  if (messages.has_error() && is_about_old_wkt(messages.first_error())) messages.clear_error();
  if (messages.has_error()) return tl::unexpected(cannot_write(target, messages, "all of it"));
  for (const auto& warning : messages.take_warnings()) {
    if (!is_harmless(warning)) {
      return output_failure(std::filesystem::path(target.path).filename().string() + ": " +
                            warning);
    }
  }
  return {};
}

}  // namespace mapwright::converter
