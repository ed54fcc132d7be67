// National and common grids, asked where they would put a drawing.
#pragma once

#include <string>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::converter {

/// A grid in whose area of use a place lies.
struct GridPlace {
  std::string code;  ///< "EPSG:28992"
  std::string name;  ///< "Amersfoort / RD New"
  double longitude_deg = 0.0, latitude_deg = 0.0;
  double metres_per_unit = 1.0;
  double centrality = 0.0;  ///< 1 in the middle of the area of use, 0 in its corners
};

/// Grids of the list (known_grids.cpp) that may hold the point, the most central first. Areas of
/// use are PROJ's.
std::vector<GridPlace> grids_holding(Point p);

/// Latitude that a northing of UTM stands for (northern hemisphere); NaN beyond 84 degrees.
double utm_latitude_deg(Point p);

}  // namespace mapwright::converter
