// What makes a stated CRS, or plain metres, hard to believe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/gdal/crs.hpp"
#include "mapcore/map.hpp"

namespace mapwright::converter {

/// A layer that lies outside of its CRS's area of use, or whose numbers look like degrees although
/// its CRS has metres. `extent`: in the CRS. Nothing where there is no doubt.
std::optional<std::string> doubt_about_place(const Crs& crs, const Box& extent);

/// A map whose steps are too deep or too shallow for people, or that is smaller than a door: its
/// unit is another one, or its metres are those of a map projection. `extent`: of the map;
/// `obstacles`: those that may be stairs; `latitude_deg`: of the map, nothing for plain local
/// metres.
std::optional<std::string> doubt_about_scale(const Box& extent,
                                             const std::vector<Obstacle>& obstacles,
                                             std::optional<double> latitude_deg);

}  // namespace mapwright::converter
