#include "cli/convert/convert_arguments.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/support/arguments.hpp"
#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "converter/rules/rule_reader.hpp"

namespace mapwright::cli {
namespace {

namespace po = boost::program_options;

bool is_builtin(const std::string& rules) {
  const auto& names = converter::builtin_rule_sets();
  return std::find(names.begin(), names.end(), rules) != names.end();
}

converter::RuleSet load_rules(const std::string& rules) {
  const std::string yaml =
      is_builtin(rules) ? std::string(converter::builtin_rules(rules)) : read_file(rules);
  return value_or_throw(converter::read_rules(yaml, rules));
}

// Metres that a drawing may be moved by.
double distance_option(const char* name, const std::string& text) {
  constexpr double kMost_m = 10.0;
  const double metres = parse_number(name, text);
  if (!(metres >= 0.0 && metres <= kMost_m)) {
    fail_usage("--" + std::string(name) + ": expected metres from 0 to 10, got " + text);
  }
  return metres;
}

void refuse_remote(const std::string& path) {
  if (path == "-") fail_usage("-: sources are files; GIS formats are not read from a pipe");
  if (path.find("://") != path.npos || path.find("/vsi") != path.npos) {
    fail_usage(path + ": remote and virtual sources are refused; fetch or unpack it first");
  }
}

}  // namespace

void ConvertArguments::declare(po::options_description& options,
                               po::positional_options_description& positionals) {
  auto add = options.add_options();
  add("source", po::value(&options_.sources)->required(), "GIS files, or folders of shapefiles");
  add("output,o", po::value(&output_),
      "the map to write, with its sidecar MAP.georef.json beside it; - writes the map alone to "
      "standard output");
  add("layer", po::value(&options_.layers)->composing(),
      "convert this layer only; may be given several times (default: all)");
  add("rules", po::value(&rules_)->default_value("auto"),
      "what layers and fields mean: a rules file, or a built-in set: auto, osm, cadastre, "
      "indoorgml, mapwright");
  add("explain-rules", po::bool_switch(&explain_rules_),
      "print which rules fit each layer and why, and convert nothing");
  add("where", po::value(&options_.where),
      "SQL condition on fields, such as \"height > 2\"; other features are dropped");
  add("bbox", po::value(&bbox_),
      "X1,Y1,X2,Y2 in metres of the map: features outside are dropped, those across the edge stay "
      "whole");
  frame_.declare(options, "default: the centre of the sources");
  add("source-crs", po::value(&options_.source_crs), "CRS of sources that state none");
  add("override-crs", po::value(&options_.override_crs),
      "CRS of all sources, whatever they state: for files that say the wrong one");
  add("local", po::bool_switch(&options_.local), "the sources' coordinates are those of the map");
  add("local-unit", po::value(&local_unit_),
      "metres of one unit of --local coordinates: 0.3048 for feet, 0.001 for millimetres (default: "
      "what a DXF file says, else 1)");
  add("swap-axes", po::bool_switch(&options_.swap_axes),
      "the sources have northing or latitude before easting or longitude");
  add("resolution", po::value(&resolution_)->default_value("0.001"),
      "metres that coordinates and heights are rounded to");
  add("snap", po::value(&snap_)->default_value("0"),
      "metres: vertices nearer to each other than this become one; 0: none");
  add("dissolve", po::bool_switch(&options_.dissolve),
      "solids of one height that overlap or share a wall become one outline");
  add("simplify", po::value(&simplify_)->default_value("0"),
      "metres: leave out vertices as long as the drawing stays nearer to itself than this; 0: "
      "none");
  add("report", po::value(&report_),
      "write the ledger: what became of every feature (JSON); - is standard output, with --watch "
      "one document after the other");
  add("watch", po::bool_switch(&watch_),
      "convert and validate again whenever a source is saved, until interrupted");
  add("strict", po::bool_switch(&strict_), "a repair is an error: no map is written");
  add("no-repair", po::bool_switch(&no_repair_),
      "write outlines that cross themselves as they are drawn");
  add("skip-broken", po::bool_switch(&options_.keep_broken),
      "drop features that cannot be read instead of refusing the source");
  add("source-tokens", po::bool_switch(&options_.source_tokens),
      "add source=LAYER:FEATURE to every semantic string");
  add("allow-driver", po::value(&options_.extra_drivers)->composing(),
      "let another of GDAL's drivers read sources; may be given several times");
  positionals.add("source", -1);
}

void ConvertArguments::check_frame() {
  options_.frame = frame_.parse();
  if (options_.local && !options_.source_crs.empty()) {
    fail_usage("--local and --source-crs exclude each other");
  }
  if (options_.local && !options_.override_crs.empty()) {
    fail_usage("--local and --override-crs exclude each other");
  }
  if (local_unit_.empty()) return;
  options_.local_unit_m = parse_number("local-unit", local_unit_);
  if (!(*options_.local_unit_m > 0.0)) fail_usage("--local-unit: must be greater than 0");
  if (!options_.local) {
    fail_usage("--local-unit is the unit of --local coordinates: give --local too");
  }
}

void ConvertArguments::check(const po::variables_map& values) {
  if (output_.empty() && !explain_rules_)
    fail_usage("-o MAP.txt is missing: where shall the map go?");
  if (watch_ && (output_ == "-" || explain_rules_)) {
    fail_usage("--watch needs a file to write: give -o MAP.txt");
  }
  if (output_ == "-" && report_ == "-") {
    fail_usage("standard output cannot hold both the map and the report");
  }
  for (const auto& source : options_.sources) refuse_remote(source);
  check_frame();
  if (!bbox_.empty()) {
    const auto n = parse_numbers("bbox", bbox_, 4, 4);
    options_.bbox = Box{n[0], n[1], n[2], n[3]};
    if (options_.bbox->is_empty()) fail_usage("--bbox: X1 must not exceed X2, nor Y1 Y2");
  }
  options_.resolution_m = parse_number("resolution", resolution_);
  options_.resolution_is_given = !values["resolution"].defaulted();
  if (options_.resolution_m < 1e-9 || options_.resolution_m > 10.0) {
    fail_usage("--resolution: expected metres between 1e-9 and 10, got " + resolution_);
  }
  options_.repair = !no_repair_;
  options_.snap_m = distance_option("snap", snap_);
  options_.simplify_m = distance_option("simplify", simplify_);
  options_.rules_are_guessed = rules_ == "auto";
}

std::vector<std::string> ConvertArguments::outputs() const {
  std::vector<std::string> files;
  if (!output_.empty() && output_ != "-") files = {output_, sidecar_path(output_)};
  if (!report_.empty() && report_ != "-") files.push_back(report_);
  return files;
}

converter::ConvertOptions ConvertArguments::options() const {
  converter::ConvertOptions options = options_;
  options.rules = load_rules(rules_);
  if (output_ != "-" && !output_.empty()) {
    const auto folder = std::filesystem::path(output_).parent_path().string();
    options.map_folder = folder.empty() ? "." : folder;
  }
  return options;
}

}  // namespace mapwright::cli
