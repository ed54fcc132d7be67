// The frame that an export says it comes from.
#pragma once

#include <optional>
#include <string>

#include "converter/gdal/vector_source.hpp"
#include "mapcore/georeference.hpp"

namespace mapwright::converter {

struct RecordedFrame {
  std::optional<Georeference> georeference;  ///< none: a map without a place on Earth
  std::string crs;                           ///< of the coordinates, where its code is known
  bool map_coordinates = false;              ///< coordinates are metres of the map frame
  std::optional<double> resolution_m;
};

/// Reads the feature `border` of an export. Nothing where the source is none, or its border is
/// gone. Fails (kInput) where the source cannot be read, or the border's fields make no sense.
Result<std::optional<RecordedFrame>> recorded_frame(VectorSource& source);

/// True if a layer has the fields of exported obstacles.
bool is_exported(const LayerInfo& layer);

}  // namespace mapwright::converter
