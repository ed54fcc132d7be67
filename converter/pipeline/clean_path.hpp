// A source's path as points of the map.
#pragma once

#include <span>
#include <vector>

#include "converter/source/feature.hpp"
#include "mapcore/point.hpp"
#include "mapcore/text/decimal_format.hpp"

namespace mapwright::converter {

/// A path at the map's resolution: no point twice in a row; of a closed one the first is not
/// repeated at the end.
struct CleanPath {
  std::vector<Point> points;
  bool closed = false;       ///< ended where it began
  bool had_repeats = false;  ///< the source itself had points twice in a row
  bool curved = false;
};

/// `geometry` holds coordinates of the map frame already.
CleanPath clean_path(const SourceGeometry& geometry, const SourcePath& path,
                     const text::DecimalFormat& resolution);

}  // namespace mapwright::converter
