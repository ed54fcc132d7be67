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

}  // namespace mapwright::converter
