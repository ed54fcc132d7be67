// Named places that a robot cannot get to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "navcore/exact/travel_areas.hpp"
#include "navcore/named_places.hpp"

namespace mapwright::navcore {

/// A place that the largest area does not reach.
struct CutOffPlace {
  std::string name;
  std::uint32_t obstacle = 0;  ///< the first that bears the name: position in Map::obstacles
  /// Where the robot would stand; nothing where there is no room for it beside the place.
  std::optional<Point> at;
  /// What is in the way from the largest area; nothing where no disc gets there, however small.
  std::optional<Bottleneck> gap;
};

/// Those of the finder's places beside which the robot cannot stand within the largest area, in the
/// order of the map. Requires finder and areas of the same map and robot; empty without any area.
std::vector<CutOffPlace> cut_off_places(const PlaceFinder& finder, const TravelAreas& areas,
                                        double radius_m);

}  // namespace mapwright::navcore
