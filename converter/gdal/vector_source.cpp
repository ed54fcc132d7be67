#include "converter/gdal/vector_source.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "converter/gdal/crs_of.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/feature_values.hpp"
#include "converter/gdal/geometry_paths.hpp"
#include "converter/gdal/messages.hpp"
#include "converter/gdal/open_dataset.hpp"

namespace mapwright::converter {
namespace {

GeometryKind declared_kind(OGRwkbGeometryType type) {
  const auto flat = wkbFlatten(type);
  if (flat == wkbNone) return GeometryKind::kNone;
  if (flat == wkbPoint || flat == wkbMultiPoint) return GeometryKind::kPoint;
  if (flat == wkbMultiLineString || OGR_GT_IsSubClassOf(flat, wkbMultiCurve) ||
      OGR_GT_IsCurve(flat)) {
    return GeometryKind::kLine;
  }
  if (OGR_GT_IsSubClassOf(flat, wkbCurvePolygon) || OGR_GT_IsSubClassOf(flat, wkbMultiSurface)) {
    return GeometryKind::kPolygon;
  }
  return GeometryKind::kMixed;
}

LayerInfo info_of(OGRLayer& layer) {
  LayerInfo info;
  info.name = layer.GetName();
  info.geometry = declared_kind(layer.GetGeomType());
  info.crs = crs_of(layer.GetSpatialRef());
  info.declared_features = layer.GetFeatureCount(FALSE);
  const auto* definition = layer.GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) {
    info.fields.emplace_back(definition->GetFieldDefn(i)->GetNameRef());
  }
  return info;
}

// A table in which QGIS keeps how layers look: nothing that was drawn.
bool holds_styles(OGRLayer& layer) {
  return std::string_view(layer.GetName()) == "layer_styles" && layer.GetGeomType() == wkbNone;
}

// Files of a folder come in no order of their own.
void sort_by_name(std::vector<OGRLayer*>& layers) {
  std::sort(layers.begin(), layers.end(),
            [](OGRLayer* p, OGRLayer* q) { return std::string_view(p->GetName()) < q->GetName(); });
}

// For formats that hold their layers mixed (OSM), which know no extents of layers.
std::optional<Box> extent_by_reading(GDALDataset& dataset, OGRLayer& layer) {
  if (dataset.TestCapability(ODsCRandomLayerRead) == 0) return std::nullopt;
  OGREnvelope all;
  dataset.ResetReading();
  while (true) {
    OGRLayer* owner = nullptr;
    const OGRFeatureUniquePtr feature(dataset.GetNextFeature(&owner, nullptr, nullptr, nullptr));
    if (!feature) break;
    if (owner != &layer || feature->GetGeometryRef() == nullptr) continue;
    OGREnvelope own;
    feature->GetGeometryRef()->getEnvelope(&own);
    all.Merge(own);
  }
  if (!all.IsInit()) return std::nullopt;
  return Box{all.MinX, all.MinY, all.MaxX, all.MaxY};
}

// Tells GDAL which fields nobody asks for, so that it need not decode them.
void ignore_other_fields(OGRLayer& layer, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return;
  CPLStringList ignored;
  const auto* definition = layer.GetLayerDefn();
  for (int i = 0; i < definition->GetFieldCount(); ++i) {
    const char* name = definition->GetFieldDefn(i)->GetNameRef();
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) ignored.AddString(name);
  }
  layer.SetIgnoredFields(const_cast<const char**>(ignored.List()));
}

}  // namespace

struct VectorSource::Impl {
  std::string path;
  std::string driver;
  OpenedDataset opened;
  std::vector<OGRLayer*> handles;
  std::vector<LayerInfo> layers;
  std::vector<std::string> warnings;

  Failure broken(std::size_t layer, const std::string& why, std::size_t after) const {
    return {FailureKind::kInput, path + ": layer " + layers[layer].name +
                                     " cannot be read to its end (after " + std::to_string(after) +
                                     " features): " + why};
  }
  void warn(std::size_t layer, const std::string& text) {
    warnings.push_back(path + ": layer " + layers[layer].name + ": " + text);
  }
};

VectorSource::VectorSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VectorSource::VectorSource(VectorSource&&) noexcept = default;
VectorSource& VectorSource::operator=(VectorSource&&) noexcept = default;
VectorSource::~VectorSource() = default;

const std::string& VectorSource::path() const {
  return impl_->path;
}
const std::string& VectorSource::driver() const {
  return impl_->driver;
}
const std::vector<LayerInfo>& VectorSource::layers() const {
  return impl_->layers;
}
const std::vector<std::string>& VectorSource::warnings() const {
  return impl_->warnings;
}

std::optional<Box> VectorSource::extent(std::size_t layer) {
  const GdalMessages messages;
  OGREnvelope envelope;
  if (impl_->handles[layer]->GetExtent(&envelope, TRUE) != OGRERR_NONE) {
    return extent_by_reading(*impl_->opened.dataset, *impl_->handles[layer]);
  }
  const Box box{envelope.MinX, envelope.MinY, envelope.MaxX, envelope.MaxY};
  const bool finite = std::isfinite(box.width()) && std::isfinite(box.height());
  return finite && !box.is_empty() ? std::optional(box) : std::nullopt;
}

Result<VectorSource> VectorSource::open(const std::string& path, const OpenOptions& options) {
  const auto drivers = allow_drivers(options.extra_drivers);
  if (!drivers) return tl::unexpected(drivers.error());
  auto opened = open_dataset(path, *drivers);
  if (!opened) return tl::unexpected(opened.error());

  const GdalMessages messages;
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->opened = *std::move(opened);
  impl->warnings = std::move(impl->opened.warnings);
  impl->driver = impl->opened.dataset->GetDriverName();
  for (auto* layer : impl->opened.dataset->GetLayers()) {
    if (!holds_styles(*layer)) impl->handles.push_back(layer);
  }
  if (std::filesystem::is_directory(path)) sort_by_name(impl->handles);
  for (auto* layer : impl->handles) impl->layers.push_back(info_of(*layer));
  if (impl->layers.empty()) return input_failure(path + ": holds no vector layer");
  return VectorSource(std::move(impl));
}

namespace {

// Reads one layer, feature by feature, and decides what an error of the driver means.
class LayerReader {
 public:
  LayerReader(GDALDataset& dataset, OGRLayer& layer, const LayerInfo& info,
              const ReadOptions& options)
      : dataset_(dataset),
        layer_(layer),
        mixed_(dataset.TestCapability(ODsCRandomLayerRead) != 0),
        sagitta_(options.sagitta_m / info.crs.metres_per_unit) {
    ignore_other_fields(layer, options.where.empty() ? options.fields : std::vector<std::string>());
    mixed_ ? dataset.ResetReading() : layer.ResetReading();
  }

  bool compile(const std::string& where) {
    has_condition_ = !where.empty();
    return !has_condition_ ||
           condition_.Compile(layer_.GetLayerDefn(), where.c_str()) == OGRERR_NONE;
  }

  bool next(SourceFeature& feature) {
    const OGRFeatureUniquePtr from = next_of_layer();
    if (!from) return false;
    feature.fid = from->GetFID();
    feature.warnings.clear();
    feature.reencoded.clear();
    feature.geometry.clear();
    read_values(*from, feature);
    append_paths(from->GetGeometryRef(), sagitta_, feature.geometry);
    feature.selected = !has_condition_ || condition_.Evaluate(from.get()) != 0;
    return true;
  }

 private:
  // Formats that hold their layers mixed (OSM) cannot be read layer by layer: those of others are
  // passed over.
  OGRFeatureUniquePtr next_of_layer() {
    if (!mixed_) return OGRFeatureUniquePtr(layer_.GetNextFeature());
    while (true) {
      OGRLayer* owner = nullptr;
      OGRFeatureUniquePtr from(dataset_.GetNextFeature(&owner, nullptr, nullptr, nullptr));
      if (!from || owner == &layer_) return from;
    }
  }

  GDALDataset& dataset_;
  OGRLayer& layer_;
  bool mixed_;
  double sagitta_;
  OGRFeatureQuery condition_;
  bool has_condition_ = false;
};

}  // namespace

Result<std::size_t> VectorSource::read(std::size_t layer, const ReadOptions& options,
                                       const std::function<void(SourceFeature&)>& visit) {
  GdalMessages messages;
  const auto& info = impl_->layers[layer];
  LayerReader reader(*impl_->opened.dataset, *impl_->handles[layer], info, options);
  if (!reader.compile(options.where)) {
    return usage_failure("--where: '" + options.where + "' does not fit layer " + info.name + ": " +
                         messages.first_error());
  }
  SourceFeature feature;
  std::size_t count = 0;
  while (reader.next(feature)) {
    if (messages.has_error()) {
      if (!options.keep_broken) {
        return tl::unexpected(impl_->broken(
            layer, "feature " + std::to_string(feature.fid) + ": " + messages.first_error(),
            count));
      }
      feature.warnings.push_back(messages.first_error());
      messages.clear_error();
    }
    for (auto& warning : messages.take_warnings()) feature.warnings.push_back(std::move(warning));
    ++count;
    visit(feature);
  }
  if (messages.has_error())
    return tl::unexpected(impl_->broken(layer, messages.first_error(), count));
  for (const auto& warning : messages.take_warnings()) impl_->warn(layer, warning);
  if (info.declared_features >= 0 && count != static_cast<std::size_t>(info.declared_features)) {
    const auto why = "it declares " + std::to_string(info.declared_features) + " features";
    if (!options.keep_broken) return tl::unexpected(impl_->broken(layer, why, count));
    impl_->warn(layer, why + ", " + std::to_string(count) + " could be read");
  }
  return count;
}

}  // namespace mapwright::converter
