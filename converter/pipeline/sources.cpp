#include "converter/pipeline/sources.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "converter/detective/unstated_crs.hpp"
#include "converter/gdal/archive.hpp"
#include "converter/pipeline/exported_sources.hpp"
#include "converter/pipeline/storey_layers.hpp"
#include "converter/rules/rule_fields.hpp"
#include "converter/rules/rule_reader.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

Failure without_crs(const VectorSource& source, const LayerInfo& layer,
                    const OpenedSources& opened) {
  const std::string unstated = source.path() + ": layer " + layer.name;
  if (!layer.several_crs.empty()) {
    return {FailureKind::kInput,
            unstated + " states several coordinate reference systems (" + layer.several_crs +
                "), and a layer is read in one: make a file of the features of each, or say with "
                "--source-crs EPSG:CODE which one is true of all"};
  }
  const std::string missing =
      source.driver() == "ESRI Shapefile" ? " (its .prj file is missing, empty or unreadable)" : "";
  return {
      FailureKind::kInput,
      unstated + " states no coordinate reference system" + missing +
          ": say which one it is with --source-crs EPSG:CODE, or --local if its coordinates are "
          "metres of the map" +
          crs_advice(opened.sources)};
}

// Ids of stairs are unique within a file; shapefiles of one folder are one drawing.
std::string place_of(const VectorSource& source) {
  const fs::path path(source.path());
  std::error_code error;
  const bool is_single_shapefile = source.driver() == "ESRI Shapefile" &&
                                   !fs::is_directory(path, error) && !is_archive(path.string());
  return is_single_shapefile ? path.parent_path().string() : path.string();
}

bool is_asked_for(const LayerInfo& layer, const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), layer.name) != names.end();
}

Result<void> check_layer_names(const OpenedSources& opened, const std::vector<std::string>& names) {
  std::string all;
  std::vector<std::string> known;
  for (const auto& source : opened.sources) {
    for (const auto& layer : source->layers()) {
      known.push_back(layer.name);
      all += (all.empty() ? "" : ", ") + layer.name;
    }
  }
  for (const auto& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      return usage_failure("--layer: no source has a layer '" + name + "'; the layers are " + all);
    }
  }
  return {};
}

// What the user says of the sources' CRS.
struct UserCrs {
  Crs fallback;  // of layers that state none
  Crs instead;   // of all layers, whatever they state
};

Result<Crs> parse_option(const char* name, const std::string& text) {
  if (text.empty()) return Crs();
  auto crs = parse_crs(text);
  if (!crs) return usage_failure(std::string(name) + ": " + crs.error().message);
  return crs;
}

Result<UserCrs> user_crs(const ConvertOptions& options) {
  auto fallback = parse_option("--source-crs", options.source_crs);
  if (!fallback) return tl::unexpected(fallback.error());
  auto instead = parse_option("--override-crs", options.override_crs);
  if (!instead) return tl::unexpected(instead.error());
  return UserCrs{*std::move(fallback), *std::move(instead)};
}

Result<void> open_source(const std::string& path, const ConvertOptions& options,
                         OpenedSources& opened) {
  auto source = VectorSource::open(path, {options.extra_drivers});
  if (!source) return tl::unexpected(source.error());
  opened.sources.push_back(std::make_unique<VectorSource>(*std::move(source)));
  auto frame = recorded_frame(*opened.sources.back());
  if (!frame) return tl::unexpected(frame.error());
  opened.frames.push_back(*frame);
  if (!*frame) return {};
  if (!opened.frame) opened.frame = *frame;
  const std::string lines = lines_beside(*opened.sources.back(), options);
  if (lines.empty()) return {};
  auto more = open_source(lines, options, opened);
  if (more) opened.frames.back() = *frame;
  return more;
}

// A map is of one floor: storeys that lie one above the other do not make one.
Result<void> check_storeys(VectorSource& source, const std::vector<std::string>& asked_for) {
  std::vector<Box> boxes;
  std::string names;
  bool are_stacked = false;
  for (std::size_t i = 0; i < source.layers().size(); ++i) {
    const auto& layer = source.layers()[i];
    if (layer.storey.empty() || !is_asked_for(layer, asked_for)) continue;
    const auto extent = source.extent(i);
    if (!extent) return tl::unexpected(extent.error());
    if (!*extent) continue;
    are_stacked = are_stacked || std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
                    return overlap(box, **extent);
                  });
    boxes.push_back(**extent);
    names += " --layer '" + layer.name + "'";
  }
  if (!are_stacked) return {};
  return usage_failure(source.path() +
                       ": holds storeys one above the other, and a map is of one: take one of" +
                       names);
}

// A built-in set, read when the first layer goes by it.
Result<const RuleSet*> builtin(const char* name, RuleSet& set) {
  if (!set.rules.empty()) return &set;
  auto read = read_rules(std::string(builtin_rules(name)), name);
  if (!read) return tl::unexpected(read.error());
  set = *std::move(read);
  return &set;
}

// Rules that fit a layer better than those for everything; null where there are none.
Result<const RuleSet*> rules_for(const VectorSource& source, bool is_export,
                                 OpenedSources& opened) {
  if (is_export) return builtin("mapwright", opened.mapwright_rules);
  if (source.driver() == "OSM") return builtin("osm", opened.osm_rules);
  if (source.driver() == "IndoorGML") return builtin("indoorgml", opened.indoor_rules);
  return nullptr;
}

}  // namespace

std::string attribute_file_of(const VectorSource& source) {
  return source.driver() == "MapInfo File" ? ".mid" : ".dbf";
}

namespace {

// Shapes without the attributes that rules ask for would become obstacles of another height and
// kind.
Result<void> check_attributes(LayerJob& job, bool keep_broken) {
  const auto& layer = job.info();
  if (!layer.lacks_attributes || !rules_read_fields(*job.rules, layer.name)) return {};
  job.loses_attributes = true;
  if (keep_broken) return {};
  return input_failure(
      job.source->path() + ": layer " + layer.name + ": its " + attribute_file_of(*job.source) +
      " file is missing, and with it the heights, types and names of "
      "its features; put it beside the file with the shapes, convert the shapes by themselves "
      "with --skip-broken, or by --rules that read no field");
}

Result<void> append_jobs(VectorSource& source, const std::optional<RecordedFrame>& frame,
                         const ConvertOptions& options, const UserCrs& said,
                         OpenedSources& opened) {
  if (auto checked = check_storeys(source, options.layers); !checked) return checked;
  for (std::size_t i = 0; i < source.layers().size(); ++i) {
    const auto& layer = source.layers()[i];
    if (!is_asked_for(layer, options.layers)) continue;
    LayerJob job{&source, i, layer.crs, place_of(source), &options.rules};
    if (is_exported(layer)) job.place = place_of_export(source, layer);
    if (options.rules_are_guessed) {
      auto better = rules_for(source, frame || is_exported(layer), opened);
      if (!better) return tl::unexpected(better.error());
      if (*better != nullptr) job.rules = *better;
    }
    if (frame) {
      if (auto taken = take_recorded(*frame, options, opened, job); !taken) return taken;
    }
    if (options.local)
      job.crs = {};
    else if (said.instead.is_stated())
      job.crs = said.instead;
    else if (!job.crs.is_stated() && !job.is_map_frame)
      job.crs = said.fallback;
    if (auto checked = check_attributes(job, options.keep_broken); !checked) return checked;
    const bool has_places = layer.geometry != GeometryKind::kNone;
    if (!options.local && !job.is_map_frame && has_places && !job.crs.is_stated()) {
      return tl::unexpected(without_crs(source, layer, opened));
    }
    opened.jobs.push_back(std::move(job));
  }
  return {};
}

// The box's outline, so that a turned or bent box is covered well enough for a centre.
void append_outline(const Box& box, std::vector<double>& xs, std::vector<double>& ys) {
  for (const double s : {0.0, 0.5, 1.0}) {
    for (const double t : {0.0, 0.5, 1.0}) {
      xs.push_back(box.min_x + s * box.width());
      ys.push_back(box.min_y + t * box.height());
    }
  }
}

bool are_degrees(const std::vector<double>& xs, const std::vector<double>& ys) {
  const auto within = [](double limit) {
    return [limit](double value) { return std::abs(value) <= limit; };
  };
  return std::all_of(xs.begin(), xs.end(), within(360.0)) &&
         std::all_of(ys.begin(), ys.end(), within(90.0));
}

Failure no_degrees(const LayerJob& job, const std::vector<double>& xs,
                   const std::vector<double>& ys) {
  char range[160];
  std::snprintf(range, sizeof range, "x %.8g to %.8g and y %.8g to %.8g", xs.front(), xs.back(),
                ys.front(), ys.back());
  const std::string advice = are_degrees(ys, xs)
                                 ? "; the axes look exchanged, use --swap-axes"
                                 : "; the CRS is another one, or use --local for plain metres" +
                                       crs_advice_instead(*job.source, job.layer);
  return {FailureKind::kInput, job.source->path() + ": layer " + job.info().name +
                                   " is said to be in " + job.crs.title() + ", but " + range +
                                   " are no longitudes and latitudes" + advice};
}

double tidy(double degrees) {
  return std::round(degrees * 1e7) / 1e7;
}

}  // namespace

Result<std::unique_ptr<OpenedSources>> open_sources(const ConvertOptions& options) {
  auto opened = std::make_unique<OpenedSources>();
  const auto said = user_crs(options);
  if (!said) return tl::unexpected(said.error());
  for (const auto& path : options.sources) {
    if (auto done = open_source(path, options, *opened); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (auto checked = check_layer_names(*opened, options.layers); !checked) {
    return tl::unexpected(checked.error());
  }
  for (std::size_t i = 0; i < opened->sources.size(); ++i) {
    auto done = append_jobs(*opened->sources[i], opened->frames[i], options, *said, *opened);
    if (!done) {
      return tl::unexpected(done.error());
    }
  }
  return opened;
}

Result<GeoPoint> center_of(const OpenedSources& sources, bool swap_axes) {
  Box all = kEmptyBox;
  for (const auto& job : sources.jobs) {
    const auto extent = job.source->extent(job.layer);
    if (!extent) return tl::unexpected(extent.error());
    const auto& box = *extent;
    if (!box || !job.crs.is_stated()) continue;
    const auto transform = CrsTransform::create(job.crs, CrsTransform::Ways::kToWgs84);
    if (!transform) return tl::unexpected(transform.error());
    std::vector<double> xs, ys;
    append_outline(*box, xs, ys);
    if (swap_axes) std::swap(xs, ys);
    if (job.crs.geographic && !are_degrees(xs, ys)) return tl::unexpected(no_degrees(job, xs, ys));
    transform->to_wgs84(xs, ys);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if (std::isfinite(xs[i])) all.add({xs[i], ys[i]});
    }
  }
  if (all.is_empty()) {
    return input_failure(
        sources.sources.front()->path() +
        ": none of its features has coordinates: there is no place on Earth to put the "
        "origin at");
  }
  return GeoPoint{tidy(0.5 * (all.min_x + all.max_x)), tidy(0.5 * (all.min_y + all.max_y))};
}

std::string relative_path(const std::string& path, const std::string& folder) {
  if (folder.empty()) return path;
  std::error_code error;
  const auto relative = fs::relative(path, folder, error);
  return error || relative.empty() ? path : relative.generic_string();
}

}  // namespace mapwright::converter
