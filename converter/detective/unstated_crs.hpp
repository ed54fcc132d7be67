// What to tell somebody whose layer states no CRS.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/vector_source.hpp"

namespace mapwright::converter {

/// Ranked guesses as lines under a message; empty where the layers say nothing. Reads the layers
/// without CRS of all sources, and asks the extents of those that state one: of the sources, and of
/// shapefiles beside them.
std::string crs_advice(const std::vector<std::unique_ptr<VectorSource>>& sources);

/// What speaks against a stated Web Mercator: `doubt_about_web_mercator` for a layer, with the
/// evidence of all layers of its source. Nothing where its numbers cannot be another CRS's.
std::optional<std::string> doubt_about_stated_metres(VectorSource& source, const Crs& crs,
                                                     const Box& extent);

/// The same as `crs_advice` for one layer that states degrees and has other coordinates, as GeoJSON
/// files of exports do that do not know better.
std::string crs_advice_instead(VectorSource& source, std::size_t layer);

}  // namespace mapwright::converter
