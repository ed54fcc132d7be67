// Ground metres that were called Web Mercator.
#pragma once

#include <optional>
#include <string>

#include "converter/detective/evidence.hpp"
#include "converter/gdal/crs.hpp"

namespace mapwright::converter {

/// True where numbers that are said to be Web Mercator may as well be UTM's: an easting of UTM read
/// as Web Mercator is a longitude of 1.5 to 7.5 degrees, and so is a part of Europe.
bool may_be_utm(const Crs& crs, const Box& extent);

/// What speaks for UTM: the place is in the sea, or sizes are those of buildings only if a unit is
/// a metre on the ground. Nothing where nothing does. `extent` and `evidence` of a drawing for
/// which `may_be_utm` holds.
std::optional<std::string> doubt_about_web_mercator(const Box& extent,
                                                    const DrawingEvidence& evidence);

}  // namespace mapwright::converter
