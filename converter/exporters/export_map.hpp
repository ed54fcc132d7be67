// A map as files of other programs: the exporters of exporters.def.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/georeference.hpp"
#include "mapcore/map.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// What an occupancy grid shall show.
struct GridOptions {
  double cell_m = 0.05;
  double above_m = 0.0;  ///< segments higher than this occupy cells
};

struct ExportJob {
  const Map& map;
  std::optional<Georeference> georeference;
  /// "EPSG:25831" and the like; "map": metres of the map frame; empty: what suits the format
  std::string crs;
  GridOptions grid;
  std::string folder;  ///< where the files go; nothing of their names stands there yet
  std::string stem;    ///< of their names
};

struct Exported {
  std::vector<std::string> files;     ///< names within the folder, the one asked for first
  std::vector<std::string> warnings;  ///< what the format cannot carry
};

struct Exporter {
  std::string_view extension;  ///< ".gpkg"
  std::string_view summary;    ///< what it writes, for --help
  Result<Exported> (*run)(const ExportJob&);
};

/// All exporters, in the order of exporters.def.
const std::vector<Exporter>& exporters();

/// The exporter that a path's extension names, in any case; nothing where there is none.
const Exporter* exporter_for(std::string_view path);

}  // namespace mapwright::converter
