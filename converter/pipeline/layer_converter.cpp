#include "converter/pipeline/layer_converter.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>

#include "converter/source/geometry_parts.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::converter {
namespace {

// Without a way out in the middle, so that several are looked at at a time; not-a-number is nowhere
// within.
bool are_within(const std::vector<double>& values, double reach) {
  bool within = true;
  for (const double value : values) within = within & (std::abs(value) <= reach);
  return within;
}

bool all_within(const SourceGeometry& geometry, double reach) {
  return are_within(geometry.xs, reach) && are_within(geometry.ys, reach);
}

bool all_finite(const SourceGeometry& geometry) {
  return all_within(geometry, DBL_MAX);
}

// A layer's name as a label.
std::string label_of(const std::string& layer) {
  std::string label = sanitized_semantic(layer);
  std::replace(label.begin(), label.end(), ',', ' ');
  return label;
}

bool meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

std::string with_metres(const char* format, double a, double b) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, a, b);
  return buffer;
}

// How many points there are to be placed: a ring's last point is its first once more, and costs as
// much.
std::size_t points_to_place(const SourceGeometry& geometry) {
  const auto& xs = geometry.xs;
  const auto& ys = geometry.ys;
  const bool is_ring = geometry.paths.size() == 1 && xs.size() > 1 && xs.front() == xs.back() &&
                       ys.front() == ys.back();
  return is_ring ? xs.size() - 1 : xs.size();
}

// Takes the point that was left out there too.
void close_ring(SourceGeometry& geometry, std::size_t placed) {
  if (placed == geometry.xs.size()) return;
  geometry.xs.back() = geometry.xs.front();
  geometry.ys.back() = geometry.ys.front();
}

bool is_directional(FeatureKind kind) {
  return kind == FeatureKind::kRamp || kind == FeatureKind::kStairs;
}

}  // namespace

LayerConverter::LayerConverter(const ConvertOptions& options, const LayerJob& job,
                               MapTransform transform, std::size_t source, Workspace& workspace,
                               StairsCollector& stairs, ExportedObstacles& exported)
    : options_(options),
      job_(job),
      transform_(std::move(transform)),
      source_(source),
      workspace_(workspace),
      stairs_(stairs),
      exported_(exported),
      exchange_(job.info().fields),
      ramps_(workspace),
      rules_(*job.rules, job.info()),
      layer_label_(label_of(job.info().name)) {}

Result<void> LayerConverter::run() {
  ReadOptions reading;
  reading.where = options_.where;
  reading.sagitta_m = 0.9 * tolerance::kChordSagitta_m;  // the rest is for rounding
  reading.fields = rules_.fields();
  reading.keep_broken = options_.keep_broken;
  const auto count =
      job_.source->read(job_.layer, reading, [this](SourceFeature& f) { convert(f); });
  if (failure_) return tl::unexpected(*failure_);
  if (!count) return tl::unexpected(count.error());
  if (static_cast<std::int64_t>(*count) < job_.info().declared_features) {
    workspace_.is_incomplete = true;  // with --skip-broken; without, the source was refused
  }
  if (suspicion_.is_suspect()) {
    return input_failure(job_.source->path() + ": layer " + job_.info().name +
                         ": longitude and latitude look exchanged (right angles are right only the "
                         "other way round): use --swap-axes");
  }
  if (suspicion_.is_doubtful()) {
    workspace_.warnings.push_back(
        job_.source->path() + ": layer " + job_.info().name +
        ": longitude and latitude may be exchanged: most of its corners are right angles only the "
        "other way round; if they are, --swap-axes");
  }
  ramps_.finish();
  return {};
}

void LayerConverter::convert(SourceFeature& feature) {
  if (failure_) return;
  if (options_.progress && ++done_ % 1024 == 0) {
    const auto total = job_.info().declared_features;
    options_.progress(done_, total > 0 ? static_cast<std::size_t>(total) : done_);
  }
  const std::size_t account = workspace_.ledger.open(source_, feature.fid);
  if (geometry_kind(feature.geometry) == GeometryKind::kMixed && feature.selected) {
    return convert_parts(feature, account);
  }
  convert_part(feature, account);
}

// A geometry collection: what a rule for polygons makes of its polygons, a rule for lines makes of
// its lines. What no rule makes anything of is left out, which changes the feature.
void LayerConverter::convert_parts(const SourceFeature& feature, std::size_t account) {
  auto& outcome = workspace_.ledger.features[account].outcome;
  bool is_built = false, is_changed = false;
  SourceFeature part = feature;
  for (auto& geometry : parts_by_kind(feature.geometry)) {
    outcome = Outcome::kWritten;
    part.geometry = std::move(geometry);
    convert_part(part, account);
    is_built = is_built || outcome != Outcome::kDropped;
    is_changed = is_changed || outcome != Outcome::kWritten;
    part.warnings.clear();  // told once
    part.lost.clear();
  }
  outcome = !is_built ? Outcome::kDropped : is_changed ? Outcome::kChanged : Outcome::kWritten;
}

void LayerConverter::convert_part(SourceFeature& feature, std::size_t account) {
  if (!selects(feature, account) || !interprets(feature, account)) return;
  if (!places(feature, account) || !keeps(feature, account)) return;
  tell_about_values(feature, account);
  build({feature, meaning_, account, source_, grid_north_, is_plain()});
}

// Whether nothing is left to be done to what the feature becomes: tidying looks at the whole
// drawing, and loose lines of drawings are joined.
bool LayerConverter::is_plain() const {
  if (options_.snap_m > 0.0 || options_.simplify_m > 0.0 || options_.dissolve) return false;
  const auto kind = meaning_.rule->kind;
  return kind == FeatureKind::kSolid || kind == FeatureKind::kRoom ||
         (kind == FeatureKind::kWall && !job_.info().chains_lines);
}

bool LayerConverter::is_exported_obstacle(const SourceFeature& feature) {
  rules_.interpret(feature, geometry_kind(feature.geometry), meaning_);
  return meaning_.rule != nullptr && meaning_.rule->kind == FeatureKind::kObstacle;
}

// Whether there is anything to convert.
bool LayerConverter::selects(const SourceFeature& feature, std::size_t account) {
  auto& ledger = workspace_.ledger;
  if (!feature.selected) {
    ledger.drop(account, FindingCode::C214, "not selected by --where");
    return false;
  }
  for (const auto& warning : feature.warnings) ledger.change(account, FindingCode::C224, warning);
  if (!feature.lost.empty() && (would_build(feature) || fits_building(feature))) {
    ledger.change(account, FindingCode::C229, feature.lost);
  }
  if (!feature.broken.empty()) {
    // Only what a rule would have made something of is lost.
    if (would_build(feature) || interprets(feature, account)) {
      ledger.drop(account, FindingCode::C229, feature.broken);
    }
    return false;
  }
  const auto& geometry = feature.geometry;
  if (!geometry.paths.empty()) {
    if (!geometry.unsupported.empty()) {
      ledger.change(account, FindingCode::C207,
                    "a part of type " + geometry.unsupported + " was left out");
    }
    return true;
  }
  if (is_exported_obstacle(feature)) return true;  // one without segments
  if (!geometry.unsupported.empty()) {
    ledger.drop(account, FindingCode::C207, "no obstacle can stand for a " + geometry.unsupported);
  } else {
    ledger.drop(account, FindingCode::C206,
                geometry.type.empty() ? "the feature has no geometry"
                                      : "its " + geometry.type + " is empty");
  }
  return false;
}

// Whether a rule would have made something of a feature without readable geometry. In a layer of
// all kinds it may have been of any.
bool LayerConverter::would_build(const SourceFeature& feature) {
  if (job_.info().geometry != GeometryKind::kMixed) return false;
  const auto builds = [&](GeometryKind kind) {
    rules_.interpret(feature, kind, meaning_);
    return meaning_.rule != nullptr && meaning_.rule->kind != FeatureKind::kIgnore;
  };
  return builds(GeometryKind::kPolygon) || builds(GeometryKind::kLine) ||
         builds(GeometryKind::kPoint);
}

bool LayerConverter::fits_building(const SourceFeature& feature) {
  rules_.interpret(feature, geometry_kind(feature.geometry), meaning_);
  return meaning_.rule != nullptr && meaning_.rule->kind != FeatureKind::kIgnore;
}

// Whether a rule makes something of it.
bool LayerConverter::interprets(const SourceFeature& feature, std::size_t account) {
  const auto kind = feature.broken.empty() ? geometry_kind(feature.geometry) : job_.info().geometry;
  rules_.interpret(feature, kind, meaning_);
  if (meaning_.rule == nullptr) {
    workspace_.ledger.drop(account, FindingCode::C209, "no rule of " + job_.rules->name + " fits");
    return false;
  }
  if (meaning_.rule->kind != FeatureKind::kIgnore) return true;
  const auto& reason = meaning_.rule->reason;
  workspace_.ledger.drop(
      account, FindingCode::C208,
      "rule '" + meaning_.rule->name + "': " + (reason.empty() ? "to be ignored" : reason));
  return false;
}

// In degrees, as declared: the whole layer is wrong where one latitude is impossible.
bool LayerConverter::check_degrees(const SourceFeature& feature) {
  if (!job_.crs.geographic) return true;
  for (std::size_t i = 0; i < feature.geometry.ys.size(); ++i) {
    const double x = feature.geometry.xs[i];
    const double y = feature.geometry.ys[i];
    if (std::abs(y) <= 90.0 && std::abs(x) <= 360.0) continue;
    const bool exchanged = std::abs(x) <= 90.0 && std::abs(y) <= 180.0;
    failure_ =
        Failure{FailureKind::kInput,
                job_.source->path() + ": layer " + job_.info().name + ": feature " +
                    std::to_string(feature.fid) + ": " +
                    with_metres("longitude %.10g, latitude %.10g is no place on Earth: ", x, y) +
                    (exchanged ? "the axes look exchanged, use --swap-axes"
                               : "the coordinates are not degrees; state their CRS, or --local")};
    return false;
  }
  suspicion_.watch(feature.geometry);
  return true;
}

// Exported coordinates must round to what they were; a map that is finer than the quick way is
// exact goes point by point.
void LayerConverter::place_exactly(std::span<double> xs, std::span<double> ys) {
  constexpr double kFine_m = 10.0 * TransformPatches::kBound_m;
  options_.resolution_m < kFine_m ? transform_.apply_exactly(xs, ys) : transform_.apply(xs, ys);
}

void LayerConverter::place(SourceGeometry& geometry) {
  const std::size_t count = points_to_place(geometry);
  transform_.apply(std::span(geometry.xs).first(count), std::span(geometry.ys).first(count));
  close_ring(geometry, count);
}

// What most features need: their coordinates are sound because they lie beside those before.
bool LayerConverter::places_nearby(SourceGeometry& geometry) {
  const auto kind = meaning_.rule->kind;
  if (options_.swap_axes || job_.crs.geographic || geometry.xs.empty()) return false;
  if (kind == FeatureKind::kObstacle || is_directional(kind)) return false;
  const std::size_t count = points_to_place(geometry);
  if (!transform_.apply_nearby(std::span(geometry.xs).first(count),
                               std::span(geometry.ys).first(count),
                               tolerance::kAbsurdCoordinate_m)) {
    return false;
  }
  close_ring(geometry, count);
  return true;
}

// Heights come in the unit of the plane; beside degrees they are metres.
void LayerConverter::take_heights_in_metres(SourceGeometry& geometry) const {
  const double local_m = options_.local_unit_m.value_or(job_.info().metres_per_local_unit);
  const double unit_m = !job_.crs.is_stated() ? local_m
                        : job_.crs.geographic ? 1.0
                                              : job_.crs.metres_per_unit;
  if (unit_m == 1.0) return;
  for (double& z : geometry.zs) z *= unit_m;
}

// Takes the geometry into the map frame.
bool LayerConverter::places(SourceFeature& feature, std::size_t account) {
  auto& geometry = feature.geometry;
  auto& ledger = workspace_.ledger;
  take_heights_in_metres(geometry);
  if (places_nearby(geometry)) return true;
  if (!all_finite(geometry)) {
    ledger.drop(account, FindingCode::C205, "a coordinate is infinite or not a number");
    return false;
  }
  if (options_.swap_axes) std::swap(geometry.xs, geometry.ys);
  if (!check_degrees(feature)) return false;
  if (meaning_.rule->kind == FeatureKind::kObstacle) {
    place_exactly(geometry.xs, geometry.ys);
    return true;
  }
  if (is_directional(meaning_.rule->kind)) {
    grid_north_ = transform_.grid_north(geometry.xs.front(), geometry.ys.front());
  }
  place(geometry);
  if (all_within(geometry, tolerance::kAbsurdCoordinate_m)) return true;
  if (!all_finite(geometry)) {
    ledger.drop(account, FindingCode::C205,
                "a coordinate is beyond what " + job_.crs.title() + " covers");
    return false;
  }
  const Box box = extent_of(geometry);
  const double reach = std::max(
      {std::abs(box.min_x), std::abs(box.max_x), std::abs(box.min_y), std::abs(box.max_y)});
  ledger.drop(
      account, FindingCode::C220,
      with_metres("it lies %.0f km from the map's origin; are --origin, the CRS and the order of "
                  "the axes right?",
                  reach / 1000.0, 0.0));
  return false;
}

// Whether the robot can meet it.
bool LayerConverter::keeps(const SourceFeature& feature, std::size_t account) {
  const bool has_place = !feature.geometry.xs.empty();
  if (options_.bbox && has_place && !meet(*options_.bbox, extent_of(feature.geometry))) {
    workspace_.ledger.drop(account, FindingCode::C213, "outside of --bbox");
    return false;
  }
  const double robot = workspace_.settings.robot_height_m;
  if (meaning_.base_height_m && *meaning_.base_height_m > robot) {
    workspace_.ledger.drop(account, FindingCode::C210,
                           with_metres("it begins %.3g m above the ground, over a robot of %.3g m",
                                       *meaning_.base_height_m, robot));
    return false;
  }
  return true;
}

void LayerConverter::tell_about_values(const SourceFeature& feature, std::size_t account) {
  auto& ledger = workspace_.ledger;
  if (job_.loses_attributes) {
    ledger.change(account, FindingCode::C231,
                  "the " + attribute_file_of(*job_.source) +
                      " file with its height, type and name is missing: defaults stand in");
  }
  for (const auto& value : meaning_.unreadable) {
    ledger.change(account, FindingCode::C219, value + " is no quantity and was passed over");
  }
  for (const auto& field : feature.reencoded) {
    ledger.change(account, FindingCode::C226,
                  "field " + field + " was not UTF-8 and was read as ISO-8859-1");
  }
  if (meaning_.rule->kind == FeatureKind::kObstacle) return;
  if (meaning_.semantic_altered) {
    ledger.change(account, FindingCode::C215,
                  "characters the map format reserves were replaced in the semantic string");
  }
  if (meaning_.semantic.empty()) meaning_.semantic = layer_label_;
  if (!options_.source_tokens) return;
  meaning_.semantic = std::string(
      Semantic(meaning_.semantic)
          .with_value(semantic_key::kSource, layer_label_ + ":" + std::to_string(feature.fid))
          .view());
}

}  // namespace mapwright::converter
