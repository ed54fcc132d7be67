#include "converter/gdal/gml_features.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "converter/gdal/stored_file.hpp"
#include "converter/gdal/xml_walk.hpp"
#include "converter/source/wrapped_reader.hpp"

namespace mapwright::converter {
namespace {

constexpr std::array<std::string_view, 24> kGeometries{"Point",
                                                       "LineString",
                                                       "LinearRing",
                                                       "Polygon",
                                                       "Curve",
                                                       "Surface",
                                                       "Solid",
                                                       "Box",
                                                       "MultiPoint",
                                                       "MultiLineString",
                                                       "MultiPolygon",
                                                       "MultiCurve",
                                                       "MultiSurface",
                                                       "MultiSolid",
                                                       "MultiGeometry",
                                                       "CompositeCurve",
                                                       "CompositeSurface",
                                                       "CompositeSolid",
                                                       "GeometricComplex",
                                                       "OrientableCurve",
                                                       "OrientableSurface",
                                                       "PolyhedralSurface",
                                                       "TriangulatedSurface",
                                                       "Tin"};

bool is_gml(std::string_view name) {
  return name.starts_with("http://www.opengis.net/gml");
}

bool is_geometry(std::string_view name) {
  return is_gml(name) &&
         std::find(kGeometries.begin(), kGeometries.end(), local_name(name)) != kGeometries.end();
}

bool holds_features(std::string_view name) {
  const auto local = local_name(name);
  return local == "featureMember" || local == "featureMembers" || local == "member";
}

bool is_collection(std::string_view name) {
  return local_name(name).ends_with("FeatureCollection");
}

// Of the features of one name, which GDAL makes a layer of.
struct GmlLayer {
  std::size_t features = 0;
  std::map<std::size_t, std::vector<std::string>> several;  // properties with geometries, by place
  std::set<std::string> crs;                                // names
};

class FeatureScan : public XmlWalk {
 public:
  std::map<std::string, GmlLayer> find(const std::string& path) {
    walk(path);
    return std::move(layers_);
  }

 private:
  void begin(std::string_view name, Attributes attributes) override {
    const bool is_feature = feature_depth_ == 0 && !open_.empty() && holds_features(open_.back()) &&
                            !is_collection(name);
    if (is_feature) begin_feature(local_name(name));
    if (layer_ != nullptr && passed_depth_ == 0 && geometry_depth_ == 0) look_at(name);
    if (geometry_depth_ > 0) take_crs(attributes);
    open_.emplace_back(name);
    if (is_feature) feature_depth_ = open_.size();
  }

  void end(std::string_view) override {
    if (open_.size() == feature_depth_) end_feature();
    if (open_.size() == geometry_depth_) geometry_depth_ = 0;
    if (open_.size() == passed_depth_) passed_depth_ = 0;
    open_.pop_back();
  }

  void text(std::string_view) override {}

  void begin_feature(std::string_view name) {
    layer_ = &layers_[std::string(name)];
    properties_.clear();
  }

  // What bounds a feature is none of its shapes.
  void look_at(std::string_view name) {
    if (is_gml(name) && local_name(name) == "boundedBy") passed_depth_ = open_.size() + 1;
    if (!is_geometry(name) || open_.empty()) return;
    geometry_depth_ = open_.size() + 1;
    properties_.emplace_back(local_name(open_.back()));
  }

  void take_crs(Attributes attributes) {
    for (; *attributes != nullptr; attributes += 2) {
      if (std::string_view(attributes[0]) == "srsName") layer_->crs.emplace(attributes[1]);
    }
  }

  void end_feature() {
    if (properties_.size() > 1) layer_->several[layer_->features] = properties_;
    ++layer_->features;
    layer_ = nullptr;
    feature_depth_ = 0;
  }

  std::map<std::string, GmlLayer> layers_;
  GmlLayer* layer_ = nullptr;            // of the feature at hand
  std::vector<std::string> properties_;  // of the feature at hand that hold geometries
  std::vector<std::string> open_;        // elements
  std::size_t feature_depth_ = 0, geometry_depth_ = 0, passed_depth_ = 0;  // 0: in none
};

template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// With a schema GDAL knows of all geometries, and the reader of its layers tells of them.
bool has_schema(const std::string& path) {
  const auto is_there = [&](const char* extension) {
    const auto beside = std::filesystem::path(path).replace_extension(extension);
    return stored_bytes(beside.string()).has_value();
  };
  return is_there(".xsd") || is_there(".gfs");
}

class GmlReader : public WrappedReader {
 public:
  GmlReader(std::unique_ptr<SourceReader> reader, const std::string& path)
      : WrappedReader(std::move(reader)), found_(FeatureScan().find(path)) {
    const bool knows_geometries = has_schema(path);
    for (auto& [name, layer] : found_) {
      if (knows_geometries) layer.several.clear();
    }
    for (auto& layer : own_layers()) {
      const auto& names = found_[layer.name].crs;
      if (!layer.crs.is_stated() && names.size() > 1) layer.several_crs = listed(names);
    }
  }

  // GDAL hands out the features of a layer in the order of the document.
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    const auto& several = found_[layers()[layer].name].several;
    std::size_t place = 0;
    return behind().read(layer, options, [&](SourceFeature& feature) {
      const auto found = several.find(place++);
      if (found != several.end()) feature.lost = loss_of(found->second);
      visit(feature);
    });
  }

 private:
  static std::string loss_of(const std::vector<std::string>& properties) {
    return "it has " + std::to_string(properties.size()) + " geometries (" + listed(properties) +
           "), of which only the last is read: make features of the others, or put the schema (" +
           ".xsd) beside the document";
  }

  std::map<std::string, GmlLayer> found_;
};

}  // namespace

std::unique_ptr<SourceReader> with_told_geometries(std::unique_ptr<SourceReader> reader,
                                                   const std::string& path) {
  return std::make_unique<GmlReader>(std::move(reader), path);
}

}  // namespace mapwright::converter
