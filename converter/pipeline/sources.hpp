// The layers a conversion reads, and where they lie.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/vector_source.hpp"
#include "converter/pipeline/convert.hpp"
#include "converter/pipeline/map_transform.hpp"
#include "converter/pipeline/recorded_frame.hpp"
#include "converter/rules/layer_rules.hpp"

namespace mapwright::converter {

/// One layer to convert.
struct LayerJob {
  VectorSource* source = nullptr;
  std::size_t layer = 0;  ///< in the source
  Crs crs;                ///< the layer's own, or --source-crs; none for --local
  std::string place;      ///< what its stair ids are unique within
  const RuleSet* rules = nullptr;
  bool is_map_frame = false;      ///< metres of the map that was exported
  bool loses_attributes = false;  ///< the rules ask for attributes that are gone

  const LayerInfo& info() const { return source->layers()[layer]; }
};

struct OpenedSources {
  std::vector<std::unique_ptr<VectorSource>> sources;
  std::vector<LayerJob> jobs;
  RuleSet osm_rules, indoor_rules, mapwright_rules;  ///< empty until a layer goes by them
  std::vector<std::optional<RecordedFrame>> frames;  ///< by source; of those that are exports
  std::optional<RecordedFrame> frame;                ///< the first of them
};

/// Opens all sources and picks the layers asked for. Fails for unknown layer names (kUsage) and
/// layers without CRS (kInput; the message says how to state one).
Result<std::unique_ptr<OpenedSources>> open_sources(const ConvertOptions& options);

/// Extension of the file that holds the attributes of a format of several files.
std::string attribute_file_of(const VectorSource& source);

/// Centre of the layers' extents on WGS 84, rounded to 1e-7 degrees. Fails (kInput) where there is
/// none.
Result<GeoPoint> center_of(const OpenedSources& sources, bool swap_axes);

/// A path as the sidecar and the ledger keep it: relative to `folder` where that can be.
std::string relative_path(const std::string& path, const std::string& folder);

}  // namespace mapwright::converter
