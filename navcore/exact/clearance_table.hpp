// How much of a map stays connected as the robot grows, and which places it loses.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// What a disc of one radius can do in a map. Areas are those of the disc's centre, m².
struct ClearanceRow {
  double radius_m = 0.0;
  double free_area_m2 = 0.0;     ///< where it can stand
  double largest_area_m2 = 0.0;  ///< the largest part it can travel
  std::size_t components = 0;    ///< parts between which it cannot travel (TravelAreas)

  /// Named places that the largest part does not reach although the row before does (the first
  /// row: all it does not reach), in the order of the map.
  std::vector<std::string> places_lost;

  /// Of where it can stand, the share it can travel; 0 where it can stand nowhere.
  double share() const { return free_area_m2 > 0.0 ? largest_area_m2 / free_area_m2 : 0.0; }
};

struct ClearanceTable {
  std::vector<ClearanceRow> rows;
  std::size_t places = 0;  ///< named places of the map
};

/// One row for each radius (metres; 0 for a point), in ascending order, each once. A place is
/// reached where the robot can stand beside it (PlaceFinder) within the largest part. Failures:
/// those of ExactPlanner::build.
Result<ClearanceTable> clearance_table(const Map& map, RampPolicy ramps,
                                       std::span<const double> radii_m);

}  // namespace mapwright::navcore
