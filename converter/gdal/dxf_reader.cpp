#include "converter/gdal/dxf_reader.hpp"

#include <cpl_conv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <map>

#include "converter/gdal/dxf_entities.hpp"
#include "converter/gdal/dxf_header.hpp"
#include "converter/source/wrapped_reader.hpp"

namespace mapwright::converter {
namespace {

// GDAL draws arcs as chords of this angle: on a circle of 250 m they stay nearer than 1 cm.
constexpr const char* kArcStep_deg = "1";

// A drawing of a place a robot drives in is not smaller, and hardly larger.
constexpr double kLeastPlace_m = 2.0;
constexpr double kGreatestPlace_m = 1.0e5;

constexpr std::array<const char*, 4> kCurves{"AcDbCircle", "AcDbArc", "AcDbEllipse", "AcDbSpline"};

// Lettering, and blocks that may hold nothing: no loss without a shape.
constexpr std::array<const char*, 6> kMayBeBare{
    "AcDbBlockReference", "AcDbMLeader", "AcDbLeader", "AcDbText", "AcDbMText", "AcDbDimension"};

template <std::size_t N>
bool is_one_of(const std::array<const char*, N>& names, const std::string& classes) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return classes.find(name) != classes.npos; });
}

const std::string* text_of(const SourceFeature& feature, std::size_t field) {
  return field < feature.values.size() ? std::get_if<std::string>(&feature.values[field]) : nullptr;
}

std::size_t position_of(const std::vector<std::string>& fields, const std::string& name) {
  return static_cast<std::size_t>(std::find(fields.begin(), fields.end(), name) - fields.begin());
}

std::string number(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

// The whole drawing is one layer of GDAL's: where each feature belongs is found out once.
class DxfReader : public WrappedReader {
 public:
  DxfReader(const GdalInput& input, std::unique_ptr<SourceReader> drawing)
      : WrappedReader(std::move(drawing)), title_(input.title) {
    const auto& fields = behind().layers()[0].fields;
    layer_field_ = position_of(fields, "Layer");
    class_field_ = position_of(fields, "SubClasses");
    own_layers().clear();
  }

  Result<void> sort(std::optional<double> stated_unit_m, UnreadEntities unread) {
    std::map<std::string, Found> found;
    lost_ = std::move(unread.lost);
    for (const auto& entity : lost_) ++found[entity.layer].features;
    tell_passed_over(unread.passed_over);
    ReadOptions options;
    options.keep_broken = true;  // whether that is allowed is decided when the layer is read
    const auto count = behind().read(0, options, [&](SourceFeature& feature) {
      auto& layer = found[layer_of(feature)];
      ++layer.features;
      last_fid_ = std::max(last_fid_, feature.fid);
      for (std::size_t i = 0; i < feature.geometry.xs.size(); ++i) {
        layer.box.add({feature.geometry.xs[i], feature.geometry.ys[i]});
      }
    });
    if (!count) return tl::unexpected(count.error());
    Box all = kEmptyBox;
    for (const auto& [name, layer] : found) {
      add_layer(name, layer);
      if (layer.box.is_empty()) continue;
      all.add({layer.box.min_x, layer.box.min_y});
      all.add({layer.box.max_x, layer.box.max_y});
    }
    behind().take_warnings();  // they come again with the layers
    if (stated_unit_m && !all.is_empty()) set_unit(*stated_unit_m, all);
    return {};
  }

  Result<std::optional<Box>> extent(std::size_t layer) override {
    return boxes_[layer].is_empty() ? std::nullopt : std::optional(boxes_[layer]);
  }

  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    std::size_t count = 0;
    ReadOptions whole = options;
    whole.fields.clear();  // which layer a feature is of is one of its fields
    const auto read = behind().read(0, whole, [&](SourceFeature& feature) {
      if (layer_of(feature) != layers()[layer].name) return;
      mark_curves(feature);
      tell_losses(feature);
      ++count;
      visit(feature);
    });
    if (!read) return tl::unexpected(read.error());
    return count + visit_lost(layer, visit);
  }

 private:
  struct Found {
    std::size_t features = 0;
    Box box = kEmptyBox;
  };

  std::string layer_of(const SourceFeature& feature) const {
    const auto* name = text_of(feature, layer_field_);
    return name == nullptr || name->empty() ? "0" : *name;
  }

  // Entities that GDAL passed over stand behind the others, so that the ledger has all of them.
  std::size_t visit_lost(std::size_t layer, const FeatureVisitor& visit) const {
    SourceFeature feature;
    feature.values.resize(layers()[layer].fields.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < lost_.size(); ++i) {
      if (lost_[i].layer != layers()[layer].name) continue;
      feature.fid = last_fid_ + 1 + static_cast<std::int64_t>(i);
      feature.values[layer_field_] = lost_[i].layer;
      feature.broken = lost_[i].why;
      visit(feature);
      ++count;
    }
    return count;
  }

  // A block that is not there is told at the entity that inserts it, not at the one read next. GDAL
  // makes rings of 3DFACE and SOLID, which are closed by nature, and calls them open.
  void tell_losses(SourceFeature& feature) const {
    std::erase_if(feature.warnings, [&](const std::string& warning) {
      const bool is_about_block =
          warning.starts_with("Block ") && warning.ends_with(" does not exist");
      return warning == "Non closed ring detected" || (is_about_block && !lost_.empty());
    });
    if (!feature.geometry.paths.empty() || !feature.broken.empty()) return;
    const auto* classes = text_of(feature, class_field_);
    if (classes != nullptr && is_one_of(kMayBeBare, *classes)) return;
    feature.broken =
        "GDAL finds no shape in it" + (classes == nullptr ? "" : " (" + *classes + ")");
  }

  void tell_passed_over(const std::vector<std::string>& kinds) {
    if (kinds.empty()) return;
    std::string all;
    for (const auto& kind : kinds) all += (all.empty() ? "" : ", ") + kind;
    warn(title_ + ": passed over, for it stands for nothing solid: " + all);
  }

  void mark_curves(SourceFeature& feature) const {
    const auto* classes = text_of(feature, class_field_);
    if (classes == nullptr) return;
    if (!is_one_of(kCurves, *classes)) return;
    for (auto& path : feature.geometry.paths) path.curved = path.role != PathRole::kPoint;
  }

  void add_layer(const std::string& name, const Found& found) {
    LayerInfo info = behind().layers()[0];
    info.name = name;
    info.declared_features = static_cast<std::int64_t>(found.features);
    info.chains_lines = true;
    own_layers().push_back(std::move(info));
    boxes_.push_back(found.box);
  }

  void set_unit(double unit_m, const Box& box) {
    const double drawn = std::max(box.width(), box.height());
    const double reach_m = drawn * unit_m;
    const bool can_be = reach_m >= kLeastPlace_m && reach_m <= kGreatestPlace_m;
    if (can_be || drawn == 0.0) {
      for (auto& layer : own_layers()) layer.metres_per_local_unit = unit_m;
      return;
    }
    warn(title_ + ": its $INSUNITS says that a unit is " + number(unit_m) +
         " m, which would make it " + number(reach_m) +
         " m wide: the unit is not believed, coordinates count as metres");
  }

  std::string title_;
  std::size_t layer_field_ = 0;
  std::size_t class_field_ = 0;
  std::vector<Box> boxes_;
  std::vector<UnreadEntity> lost_;
  std::int64_t last_fid_ = 0;
};

}  // namespace

bool is_dxf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".dxf";
}

OpenedReader open_dxf(const GdalInput& input, const DriverNotice& notice) {
  CPLSetConfigOption("OGR_ARC_STEPSIZE", kArcStep_deg);
  CPLSetConfigOption("DXF_ENCODING", dxf_is_utf8(input.path) ? "UTF-8" : nullptr);
  auto drawing = open_gdal(input, notice);
  if (!drawing || (*drawing)->driver() != "DXF") return drawing;
  auto reader = std::make_unique<DxfReader>(input, *std::move(drawing));
  auto sorted = reader->sort(dxf_metres_per_unit(input.path), unread_dxf_entities(input.path));
  if (!sorted) return tl::unexpected(sorted.error());
  if (reader->layers().empty()) return input_failure(input.title + ": the drawing is empty");
  return reader;
}

}  // namespace mapwright::converter
