#include "converter/gdal/gdal_reader.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "converter/gdal/column_reader.hpp"
#include "converter/gdal/crs_of.hpp"
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
  if (OGR_GT_IsSubClassOf(flat, wkbCurvePolygon) || OGR_GT_IsSubClassOf(flat, wkbMultiSurface) ||
      OGR_GT_IsSubClassOf(flat, wkbPolyhedralSurface)) {
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

// Names of a GeoPackage's views.
std::set<std::string> views_of(GDALDataset& dataset) {
  std::set<std::string> views;
  if (std::string_view(dataset.GetDriverName()) != "GPKG") return views;
  auto* names =
      dataset.ExecuteSQL("SELECT name FROM sqlite_master WHERE type = 'view'", nullptr, nullptr);
  if (names == nullptr) return views;
  for (const auto& row : *names) views.emplace(row->GetFieldAsString(0));
  dataset.ReleaseResultSet(names);
  return views;
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

  // Reads by columns, from the beginning, as long as they hold all there is to say about a feature;
  // tells how many.
  std::size_t read_columns(FeatureSink& sink) {
    const bool is_geopackage = std::string_view(dataset_.GetDriverName()) == "GPKG";
    if (!is_geopackage || mixed_ || has_condition_) return 0;
    auto columns = ColumnReader::open(layer_);
    if (!columns) return 0;
    std::size_t count = 0;
    for (; const FeatureRow* row = columns->next(); ++count) sink.add(*row);
    is_at_end_ = !columns->gave_up();
    columns.reset();
    if (!is_at_end_) pass_over(count);
    return count;
  }

  // One of those that follow.
  bool next(SourceFeature& feature) {
    if (is_at_end_) return false;
    const OGRFeatureUniquePtr from = next_of_layer();
    if (!from) return false;
    feature.fid = from->GetFID();
    feature.broken.clear();
    feature.lost.clear();
    feature.warnings.clear();
    feature.reencoded.clear();
    feature.geometry.clear();
    read_values(*from, feature);
    append_paths(from->GetGeometryRef(), sagitta_, feature.geometry);
    const auto& geometry = feature.geometry;
    if (geometry.paths.empty() && !geometry.unsupported.empty()) {
      feature.broken =
          "no face of its " + geometry.unsupported + " covers any ground or stands upright";
    }
    feature.selected = !has_condition_ || condition_.Evaluate(from.get()) != 0;
    return true;
  }

 private:
  // From the layer's beginning.
  void pass_over(std::size_t features) {
    layer_.ResetReading();
    for (std::size_t i = 0; i < features; ++i) {
      const OGRFeatureUniquePtr known(layer_.GetNextFeature());
    }
  }

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
  bool is_at_end_ = false;
};

class GdalReader : public SourceReader {
 public:
  GdalReader(const GdalInput& input, OpenedDataset opened)
      : path_(input.title), opened_(std::move(opened)) {
    const GdalMessages messages;
    driver_ = opened_.dataset->GetDriverName();
    warnings_ = std::move(opened_.warnings);
    for (auto* layer : opened_.dataset->GetLayers()) {
      if (!holds_styles(*layer)) handles_.push_back(layer);
    }
    if (std::filesystem::is_directory(input.path)) sort_by_name(handles_);
    const auto views = views_of(*opened_.dataset);
    for (auto* layer : handles_) {
      auto& info = layers_.emplace_back(info_of(*layer));
      info.is_view = views.count(info.name) > 0;
      tell_other_geometries(*layer);
      const auto& bare = opened_.bare_layers;
      info.lacks_attributes = std::find(bare.begin(), bare.end(), info.name) != bare.end();
    }
  }

  const std::string& driver() const override { return driver_; }
  const std::vector<LayerInfo>& layers() const override { return layers_; }
  std::vector<std::string> take_warnings() override { return std::exchange(warnings_, {}); }
  Result<std::optional<Box>> extent(std::size_t layer) override;
  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    return read_layer(layer, options, nullptr, visit);
  }
  Result<std::size_t> read_into(std::size_t layer, const ReadOptions& options,
                                FeatureSink& sink) override {
    return read_layer(layer, options, &sink, [&](SourceFeature& feature) { sink.add(feature); });
  }

 private:
  // Tables and GML with a schema may have several geometries a feature; a map has one.
  void tell_other_geometries(OGRLayer& layer) {
    const auto* definition = layer.GetLayerDefn();
    std::string others;
    for (int i = 1; i < definition->GetGeomFieldCount(); ++i) {
      others +=
          (others.empty() ? "" : ", ") + std::string(definition->GetGeomFieldDefn(i)->GetNameRef());
    }
    if (others.empty()) return;
    warnings_.push_back(path_ + ": layer " + layer.GetName() +
                        ": each feature has several geometries: the first is read, and not " +
                        others);
  }

  Failure broken(std::size_t layer, const std::string& why, std::size_t after) const {
    return {FailureKind::kInput, path_ + ": layer " + layers_[layer].name +
                                     " cannot be read to its end (after " + std::to_string(after) +
                                     (after == 1 ? " feature): " : " features): ") + why};
  }
  void warn(std::size_t layer, const std::string& text) {
    warnings_.push_back(path_ + ": layer " + layers_[layer].name + ": " + text);
  }
  Result<void> check_count(std::size_t layer, std::size_t count, bool keep_broken);
  // Rows go to `rows`, unless null, and features to `visit`.
  Result<std::size_t> read_layer(std::size_t layer, const ReadOptions& options, FeatureSink* rows,
                                 const FeatureVisitor& visit);

  std::string path_;
  OpenedDataset opened_;
  std::string driver_;
  std::vector<OGRLayer*> handles_;
  std::vector<LayerInfo> layers_;
  std::vector<std::string> warnings_;
};

Result<std::optional<Box>> GdalReader::extent(std::size_t layer) {
  const GdalMessages messages;
  OGREnvelope envelope;
  if (handles_[layer]->GetExtent(&envelope, TRUE) != OGRERR_NONE) {
    return extent_by_reading(*opened_.dataset, *handles_[layer]);
  }
  const Box box{envelope.MinX, envelope.MinY, envelope.MaxX, envelope.MaxY};
  const bool finite = std::isfinite(box.width()) && std::isfinite(box.height());
  return finite && !box.is_empty() ? std::optional(box) : std::nullopt;
}

Result<void> GdalReader::check_count(std::size_t layer, std::size_t count, bool keep_broken) {
  const auto declared = layers_[layer].declared_features;
  if (declared < 0 || count == static_cast<std::size_t>(declared)) return {};
  std::string why =
      "it declares " + std::to_string(declared) + (declared == 1 ? " feature" : " features");
  if (driver_ == "ESRI Shapefile") {
    why += " (rows that are marked as deleted count too: pack the file, as ogrinfo -sql \"REPACK " +
           layers_[layer].name + "\" does)";
  }
  if (!keep_broken) return tl::unexpected(broken(layer, why, count));
  warn(layer, why + ", " + std::to_string(count) + " could be read");
  return {};
}

Result<std::size_t> GdalReader::read_layer(std::size_t layer, const ReadOptions& options,
                                           FeatureSink* rows, const FeatureVisitor& visit) {
  GdalMessages messages;
  const auto& info = layers_[layer];
  LayerReader reader(*opened_.dataset, *handles_[layer], info, options);
  if (!reader.compile(options.where)) {
    return usage_failure("--where: '" + options.where + "' does not fit layer " + info.name + ": " +
                         messages.first_error());
  }
  std::size_t count = rows == nullptr ? 0 : reader.read_columns(*rows);
  SourceFeature feature;
  while (reader.next(feature)) {
    if (messages.has_error()) {
      const auto why = "feature " + std::to_string(feature.fid) + ": " + messages.first_error();
      if (!options.keep_broken) return tl::unexpected(broken(layer, why, count));
      feature.broken = messages.first_error();
      messages.clear_error();
    }
    for (auto& warning : messages.take_warnings()) feature.warnings.push_back(std::move(warning));
    ++count;
    visit(feature);
  }
  if (messages.has_error()) return tl::unexpected(broken(layer, messages.first_error(), count));
  for (const auto& warning : messages.take_warnings()) warn(layer, warning);
  if (auto checked = check_count(layer, count, options.keep_broken); !checked) {
    return tl::unexpected(checked.error());
  }
  return count;
}

}  // namespace

OpenedReader open_gdal(const GdalInput& input, const DriverNotice& notice) {
  auto opened = open_dataset(input, notice);
  if (!opened) return tl::unexpected(opened.error());
  auto reader = std::make_unique<GdalReader>(input, *std::move(opened));
  if (reader->layers().empty()) return input_failure(input.title + ": holds no vector layer");
  return reader;
}

}  // namespace mapwright::converter
