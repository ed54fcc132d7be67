// The whole way from sources to a map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/frame/origin.hpp"
#include "converter/ledger/ledger.hpp"
#include "converter/pipeline/converted_map.hpp"
#include "converter/rules/rule.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/progress.hpp"
#include "mapcore/tolerances.hpp"

namespace mapwright::converter {

struct ConvertOptions {
  std::vector<std::string> sources;  ///< files or folders
  std::vector<std::string> layers;   ///< names; empty: all
  std::vector<std::string> extra_drivers;
  std::string map_folder;  ///< the sidecar's paths are relative to it; empty: as given
  RuleSet rules;
  bool rules_are_guessed = false;  ///< OSM sources then go by the rules for OSM
  std::string where;               ///< SQL condition
  std::optional<Box> bbox;         ///< metres, map frame
  FrameOptions frame;
  std::string source_crs;              ///< of layers that state none
  std::string override_crs;            ///< of all layers, whatever they state
  bool local = false;                  ///< coordinates are those of the map frame, in
  std::optional<double> local_unit_m;  ///< this unit; nothing: the source's own, or metres
  double resolution_m = tolerance::kResolution_m;
  bool resolution_is_given = false;  ///< else an export's own counts
  bool repair = true;
  double snap_m = 0.0;         ///< vertices nearer than this become one; 0: none
  double simplify_m = 0.0;     ///< greatest distance vertices may be left out by; 0: none
  bool dissolve = false;       ///< touching solids of one height become one outline
  bool keep_broken = false;    ///< features that cannot be read are dropped, not fatal
  bool swap_axes = false;      ///< sources have y (latitude) before x (longitude)
  bool source_tokens = false;  ///< semantic strings name layer and feature id
  Progress progress;
};

struct Conversion {
  ConvertedMap map;
  double resolution_m = tolerance::kResolution_m;  ///< that it shall be written at
  std::optional<Georeference> georeference;        ///< nothing for plain local metres
  Ledger ledger;
  std::vector<std::string> warnings;  ///< about the whole, for the person who converts
  bool is_incomplete = false;         ///< features are missing that no account is about
};

/// Converts; writes nothing. Fails with kInput where a source cannot be read whole or has no CRS,
/// with kUsage for options that make no sense.
Result<Conversion> convert(const ConvertOptions& options);

/// What `--explain-rules` prints: for each layer the rules that can match and why.
Result<std::string> explain_rules(const ConvertOptions& options);

}  // namespace mapwright::converter
