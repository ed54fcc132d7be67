// Worlds of free polygons with published shortest lengths.
#pragma once

#include <istream>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::bench {

/// Map of a world given as GeoJSON polygons of free space: outer rings become clockwise outlines
/// (free inside), holes counter-clockwise ones. One metre a unit; the border lies one metre
/// outside. Requires well-formed GeoJSON of polygons.
Map read_polygonal_world(std::istream& geojson);

struct PublishedQuery {
  Point start, goal;
  double optimum_m = 0.0;
};

/// Lines start_x,start_y,goal_x,goal_y,optimum after a line of column names.
std::vector<PublishedQuery> read_published_queries(std::istream& csv);

}  // namespace mapwright::bench
