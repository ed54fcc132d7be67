#include "converter/gdal/kml_features.hpp"

#include <algorithm>
#include <utility>

#include "converter/gdal/kml_elements.hpp"
#include "converter/source/wrapped_reader.hpp"

namespace mapwright::converter {
namespace {

// GDAL numbers layers of one name: "walls (#2)".
bool is_named(const std::string& layer, const std::string& container) {
  if (container.empty()) return layer.starts_with("Layer");
  return layer == container || layer.starts_with(container + " (#");
}

// What a layer of GDAL's has besides what GDAL tells.
struct ToldLayer {
  std::vector<KmlFeature> features;
  std::vector<std::string> links;
};

class KmlReader : public WrappedReader {
 public:
  KmlReader(std::unique_ptr<SourceReader> reader, const KmlElements& found, std::string title)
      : WrappedReader(std::move(reader)), told_(layers().size()) {
    match(found.containers);
    for (std::size_t i = 0; i < told_.size(); ++i) {
      auto& declared = own_layers()[i].declared_features;
      if (declared >= 0) declared += static_cast<std::int64_t>(told_[i].links.size());
    }
    std::string kinds;
    for (const auto& [kind, count] : found.passed_over) {
      kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    }
    if (kinds.empty()) return;
    warn(title + ": passed over, for it stands for nothing solid: " + kinds);
  }

  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    const auto& kinds = told_[layer].features;
    std::size_t place = 0;
    std::int64_t last_fid = 0;
    const auto count = behind().read(layer, options, [&](SourceFeature& feature) {
      if (place < kinds.size()) tell(kinds[place], feature);
      ++place;
      last_fid = std::max(last_fid, feature.fid);
      visit(feature);
    });
    if (!count) return tl::unexpected(count.error());
    return *count + visit_links(layer, last_fid, visit);
  }

 private:
  // Layers come in the order of the folders; those that hold nothing but folders are none. Links of
  // folders that are no layers are told with the first layer.
  void match(const std::vector<KmlContainer>& containers) {
    std::size_t next = 0;
    for (const auto& container : containers) {
      std::size_t layer = next;
      while (layer < layers().size() && !is_named(layers()[layer].name, container.name)) ++layer;
      const bool is_layer = layer < layers().size() && holds_as_many(layer, container);
      auto& told = told_[is_layer ? layer : 0];
      told.links.insert(told.links.end(), container.links.begin(), container.links.end());
      if (!is_layer) continue;
      told.features = container.features;
      next = layer + 1;
    }
  }

  bool holds_as_many(std::size_t layer, const KmlContainer& container) const {
    const auto declared = layers()[layer].declared_features;
    return declared < 0 || static_cast<std::size_t>(declared) == container.features.size();
  }

  static void tell(KmlFeature kind, SourceFeature& feature) {
    if (kind == KmlFeature::kPicture) {
      feature.geometry.clear();
      feature.geometry.unsupported = "GroundOverlay, which is a picture";
    } else if (kind == KmlFeature::kModel) {
      auto& told = feature.geometry.paths.empty() ? feature.broken : feature.lost;
      told = "its 3D model is another file, which is not read: draw its outline as a polygon";
    }
  }

  std::size_t visit_links(std::size_t layer, std::int64_t fid, const FeatureVisitor& visit) const {
    SourceFeature feature;
    feature.values.resize(layers()[layer].fields.size());
    for (const auto& address : told_[layer].links) {
      feature.fid = ++fid;
      feature.broken = "what its NetworkLink leads to (" + address +
                       ") is not fetched: save it as a file, and name that as a source too";
      visit(feature);
    }
    return told_[layer].links.size();
  }

  std::vector<ToldLayer> told_;  ///< by layer
};

}  // namespace

std::unique_ptr<SourceReader> with_told_elements(std::unique_ptr<SourceReader> reader,
                                                 const std::string& path, std::string title) {
  const auto found = kml_elements(path);
  return std::make_unique<KmlReader>(std::move(reader), found, std::move(title));
}

}  // namespace mapwright::converter
