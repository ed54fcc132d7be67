// Sources that `export` wrote: where their parts stand, and what they say of themselves.
#pragma once

#include <string>

#include "converter/pipeline/sources.hpp"

namespace mapwright::converter {

/// True unless the options ask for another frame than an export says it has.
bool keeps_recorded_frame(const ConvertOptions& options);

/// What the positions of an exported layer's obstacles are unique within: the file; of shapefiles,
/// those that are named alike.
std::string place_of_export(const VectorSource& source, const LayerInfo& layer);

/// Sets what an export says of its coordinates where the format cannot.
Result<void> take_recorded(const RecordedFrame& frame, const ConvertOptions& options,
                           const OpenedSources& opened, LayerJob& job);

/// The shapefile with the lines of an export whose polygons are `source`; empty where there is
/// none, or the options name it already.
std::string lines_beside(const VectorSource& source, const ConvertOptions& options);

}  // namespace mapwright::converter
