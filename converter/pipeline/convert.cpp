#include "converter/pipeline/convert.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "converter/detective/doubts.hpp"
#include "converter/detective/unstated_crs.hpp"
#include "converter/frame/frame_wkt.hpp"
#include "converter/pipeline/assembly.hpp"
#include "converter/pipeline/chained_lines.hpp"
#include "converter/pipeline/exported_sources.hpp"
#include "converter/pipeline/layer_converter.hpp"
#include "converter/pipeline/leaning_walls.hpp"
#include "converter/pipeline/sources.hpp"
#include "converter/pipeline/storey_layers.hpp"
#include "converter/pipeline/tidy/dissolving.hpp"
#include "converter/pipeline/tidy/simplification.hpp"
#include "converter/pipeline/tidy/snapping.hpp"
#include "converter/rules/absent_fields.hpp"
#include "converter/rules/rule_reader.hpp"

namespace mapwright::converter {
namespace {

constexpr double kFarFromOrigin_m = 50000.0;

// An export of a map without a place on Earth stays without one.
Result<void> check_all_local(const OpenedSources& sources) {
  for (const auto& job : sources.jobs) {
    if (!job.crs.is_stated()) continue;
    return input_failure(job.source->path() + ": layer " + job.info().name + " is in " +
                         job.crs.title() +
                         ", but another source is the export of a map without a place on Earth: "
                         "give that one by --origin and --heading, or take both as metres of the "
                         "map with --local");
  }
  return {};
}

Result<Georeference> georeference_of(const ConvertOptions& options, const OpenedSources& sources) {
  if (sources.frame && sources.frame->georeference && keeps_recorded_frame(options)) {
    return *sources.frame->georeference;
  }
  GeoPoint fallback;
  if (options.frame.origin.empty()) {
    const auto center = center_of(sources, options.swap_axes);
    if (!center) return tl::unexpected(center.error());
    fallback = *center;
  }
  return resolve_frame(options.frame, fallback.latitude_deg, fallback.longitude_deg);
}

Result<std::optional<Georeference>> resolve(const ConvertOptions& options,
                                            const OpenedSources& sources) {
  const bool has_origin = !options.frame.origin.empty();
  const bool is_local = options.local || (sources.frame && !sources.frame->georeference);
  if (is_local && !has_origin) {
    if (auto checked = check_all_local(sources); !checked) return tl::unexpected(checked.error());
    return std::optional<Georeference>();
  }
  auto georeference = georeference_of(options, sources);
  if (!georeference) return tl::unexpected(georeference.error());
  georeference->wkt2 = frame_wkt2(*georeference);
  for (const auto& job : sources.jobs) {
    georeference->sources.push_back({relative_path(job.source->path(), options.map_folder),
                                     job.info().name, job.crs.definition()});
  }
  return std::optional(*std::move(georeference));
}

Result<MapTransform> transform_of(const LayerJob& job, const std::optional<LocalFrame>& frame,
                                  double local_unit_m) {
  if (!job.crs.is_stated() || !frame) return MapTransform(local_unit_m);
  auto to_wgs84 = CrsTransform::create(job.crs, CrsTransform::Ways::kToWgs84);
  if (!to_wgs84) {
    return input_failure(job.source->path() + ": layer " + job.info().name + ": " +
                         to_wgs84.error().message);
  }
  return MapTransform(*std::move(to_wgs84), *frame, job.crs);
}

// Layers of one CRS share their way to the map, and with it what it has learnt of the ground.
class Transforms {
 public:
  Transforms(const std::optional<LocalFrame>& frame, std::optional<double> local_unit_m)
      : frame_(frame), local_unit_m_(local_unit_m) {}

  Result<MapTransform> of(const LayerJob& job) {
    const Key key{job.crs.wkt, local_unit_m_.value_or(job.info().metres_per_local_unit)};
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    auto transform = transform_of(job, frame_, key.second);
    if (transform) known_.emplace(key, *transform);
    return transform;
  }

 private:
  using Key = std::pair<std::string, double>;  // WKT, unit where there is none

  const std::optional<LocalFrame>& frame_;
  std::optional<double> local_unit_m_;
  std::map<Key, MapTransform> known_;
};

// What is done to the whole drawing on request, in the order in which each helps the next.
void tidy(const ConvertOptions& options, Workspace& workspace) {
  if (options.snap_m > 0.0) snap_vertices(workspace, options.snap_m);
  if (options.dissolve) dissolve_solids(workspace);
  if (options.simplify_m > 0.0) simplify_drafts(workspace, options.simplify_m);
}

std::size_t open_account(const LayerJob& job, const ConvertOptions& options, Ledger& ledger) {
  LedgerSource source;
  source.path = relative_path(job.source->path(), options.map_folder);
  source.layer = job.info().name;
  source.crs = job.crs.title();
  ledger.sources.push_back(std::move(source));
  return ledger.sources.size() - 1;
}

Result<void> convert_layers(const ConvertOptions& options, const OpenedSources& sources,
                            const std::optional<LocalFrame>& frame, Workspace& workspace) {
  StairsCollector stairs(workspace);
  ExportedObstacles exported(workspace);
  Transforms transforms(frame, options.local_unit_m);
  for (const auto& job : sources.jobs) {
    const auto transform = transforms.of(job);
    if (!transform) return tl::unexpected(transform.error());
    const std::size_t source = open_account(job, options, workspace.ledger);
    auto done = LayerConverter(options, job, *transform, source, workspace, stairs, exported).run();
    if (!done) return done;
    workspace.ledger.sources[source].warnings = job.source->warnings();
  }
  stairs.finish();
  exported.finish();
  return {};
}

// Stated CRSs that are hard to believe. Those in degrees are meant for the whole Earth.
void append_doubts(const OpenedSources& sources, std::vector<std::string>& warnings) {
  std::set<std::pair<const VectorSource*, std::string>> doubted;  // once a source and CRS
  for (const auto& job : sources.jobs) {
    if (!job.crs.is_stated() || job.crs.geographic) continue;
    if (doubted.count({job.source, job.crs.wkt}) > 0) continue;
    const auto extent = job.source->extent(job.layer);
    if (!extent || !*extent) continue;
    auto doubt = doubt_about_place(job.crs, **extent);
    if (!doubt) doubt = doubt_about_stated_metres(*job.source, job.crs, **extent);
    if (!doubt) continue;
    warnings.push_back(job.source->path() + ": layer " + job.info().name + " " + *doubt);
    doubted.insert({job.source, job.crs.wkt});
  }
}

// A view beside the tables it shows would make each of their features two obstacles.
void append_views(const OpenedSources& sources, std::vector<std::string>& warnings) {
  for (const auto& job : sources.jobs) {
    const auto is_table = [&](const LayerJob& other) {
      return other.source == job.source && !other.info().is_view;
    };
    if (!job.info().is_view || std::none_of(sources.jobs.begin(), sources.jobs.end(), is_table)) {
      continue;
    }
    warnings.push_back(job.source->path() + ": layer " + job.info().name +
                       " is a view: what it shows of the other layers comes twice; --layer picks "
                       "those to convert");
  }
}

// Rules that a person wrote for these sources. The built-in ones know fields of all the world, and
// OSM has those fields that occur.
std::vector<std::string> slips_in_rules(const ConvertOptions& options,
                                        const OpenedSources& sources) {
  const auto& builtin = builtin_rule_sets();
  if (std::find(builtin.begin(), builtin.end(), options.rules.name) != builtin.end()) return {};
  std::vector<const LayerInfo*> layers;
  for (const auto& job : sources.jobs) {
    if (job.source->driver() == "OSM") return {};
    if (job.rules->name == options.rules.name) layers.push_back(&job.info());
  }
  return absent_fields(options.rules, layers);
}

std::vector<std::string> warnings_of(const ConvertOptions& options, const OpenedSources& sources,
                                     const std::optional<Georeference>& georeference,
                                     const ConvertedMap& map) {
  std::vector<std::string> warnings = slips_in_rules(options, sources);
  for (const auto& source : sources.sources) {
    warnings.insert(warnings.end(), source->warnings().begin(), source->warnings().end());
  }
  for (const auto& job : sources.jobs) {
    if (options.local && job.info().crs.is_stated()) {
      warnings.push_back(job.source->path() + ": layer " + job.info().name + " states " +
                         job.info().crs.title() + "; with --local its coordinates count as metres");
    }
  }
  append_views(sources, warnings);
  append_doubts(sources, warnings);
  const auto latitude =
      georeference ? std::optional(georeference->origin_latitude_deg) : std::nullopt;
  if (auto doubt = doubt_about_scale(map.extent(), map.others(), latitude))
    warnings.push_back(*std::move(doubt));
  const Border& border = map.border;
  const double away =
      std::hypot(0.5 * (border.left + border.right), 0.5 * (border.top + border.bottom));
  if (away > kFarFromOrigin_m) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "the map lies %.0f km from its origin: are --origin and the order of the axes right?",
        away / 1000.0);
    warnings.emplace_back(text);
  }
  return warnings;
}

// By position in the ledger's sources, which follow the jobs.
std::vector<bool> layers_to_chain(const OpenedSources& sources) {
  std::vector<bool> joins;
  for (const auto& job : sources.jobs) joins.push_back(job.info().chains_lines);
  return joins;
}

}  // namespace

Result<Conversion> convert(const ConvertOptions& given) {
  const auto sources = open_sources(given);
  if (!sources) return tl::unexpected(sources.error());
  const auto storeys = warning_of_storeys(**sources);
  ConvertOptions options = given;
  const auto& recorded = (*sources)->frame;
  if (!given.resolution_is_given && recorded && recorded->resolution_m) {
    options.resolution_m = *recorded->resolution_m;
  }
  auto georeference = resolve(options, **sources);
  if (!georeference) return tl::unexpected(georeference.error());
  std::optional<LocalFrame> frame;
  if (*georeference) frame.emplace(**georeference);

  Workspace workspace(options.rules.settings, options.resolution_m);
  workspace.repair = options.repair;
  auto done = convert_layers(options, **sources, frame, workspace);
  if (!done) return tl::unexpected(done.error());
  chain_lines(layers_to_chain(**sources), workspace);
  drop_walls_that_are_steps(workspace);
  tidy(options, workspace);
  if (options.repair) turn_leaning_walls(workspace);

  Conversion conversion;
  conversion.map = assemble(workspace);
  conversion.resolution_m = options.resolution_m;
  conversion.georeference = *std::move(georeference);
  conversion.ledger = std::move(workspace.ledger);
  conversion.is_incomplete = workspace.is_incomplete;
  conversion.warnings = warnings_of(options, **sources, conversion.georeference, conversion.map);
  if (storeys) conversion.warnings.push_back(*storeys);
  conversion.warnings.insert(conversion.warnings.end(), workspace.warnings.begin(),
                             workspace.warnings.end());
  assert(balances(conversion.ledger));
  return conversion;
}

Result<std::string> explain_rules(const ConvertOptions& options) {
  const auto sources = open_sources(options);
  if (!sources) return tl::unexpected(sources.error());
  std::string text;
  for (const auto& job : (*sources)->jobs) {
    const auto& info = job.info();
    text +=
        job.source->path() + ": layer " + info.name + " (" + std::string(to_string(info.geometry));
    if (info.declared_features >= 0)
      text += ", " + std::to_string(info.declared_features) + " features";
    text += ", " + (job.crs.is_stated() ? job.crs.title() : "local metres") + ")\n";
    const auto lines = LayerRules(*job.rules, info).explain();
    for (const auto& line : lines) text += "  " + line + "\n";
    if (lines.empty())
      text += "  no rule of " + job.rules->name + " fits: its features are dropped\n";
  }
  for (const auto& slip : slips_in_rules(options, **sources)) text += slip + "\n";
  return text;
}

}  // namespace mapwright::converter
