// How much of a map stays connected as the robot grows.
#pragma once

#include <span>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// What a disc of one radius can do in a map. Areas are those of the disc's centre, m².
struct ConnectedShare {
  double radius_m = 0.0;
  double free_area_m2 = 0.0;     ///< where it can stand
  double largest_area_m2 = 0.0;  ///< the largest part it can travel
  std::size_t components = 0;    ///< parts between which it cannot travel

  /// Of where it can stand, the share it can travel; 0 where it can stand nowhere.
  double share() const { return free_area_m2 > 0.0 ? largest_area_m2 / free_area_m2 : 0.0; }
};

/// One entry for each radius, in the order given (metres; 0 for a point). Areas come from the
/// offset free space with 8 tangents a quarter circle (ExactPlanner's error bounds apply: never too
/// large). Failures: those of ExactPlanner::build.
Result<std::vector<ConnectedShare>> connected_shares(const Map& map, RampPolicy ramps,
                                                     std::span<const double> radii_m);

}  // namespace mapwright::navcore
