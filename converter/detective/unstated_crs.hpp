// What to tell somebody whose layer states no CRS.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "converter/gdal/vector_source.hpp"

namespace mapwright::converter {

/// Ranked guesses as lines under a message; empty where the layers say nothing. Reads the layers
/// without CRS of all sources, and asks the extents of those that state one: of the sources, and of
/// shapefiles beside them.
std::string crs_advice(const std::vector<std::unique_ptr<VectorSource>>& sources);

/// The same for one layer that states degrees and has other coordinates, as GeoJSON files of
/// exports do that do not know better.
std::string crs_advice_instead(VectorSource& source, std::size_t layer);

}  // namespace mapwright::converter
