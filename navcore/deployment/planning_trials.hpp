// Planning runs between places of one area: does the planner find what is known to be there?
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/exact/travel_areas.hpp"
#include "navcore/free_space.hpp"
#include "navcore/planning/planner.hpp"

namespace mapwright::navcore {

struct PlanningTrialsSettings {
  std::size_t trials = 20;
  double radius_m = 0.3;
  /// Edges of at most 20 m: trees of the report's plain kind need many times the points on maps of
  /// a kilometre.
  RrtOptions rrt{100000, 20.0, 0.0};
};

/// A pair that is proved to be connected and for which no path was found.
struct MissedPair {
  Point start, goal;
  std::size_t iterations = 0;
};

struct PlanningTrials {
  std::size_t trials = 0;  ///< pairs that could be drawn; fewer than asked where there is no room
  std::size_t solved = 0;
  std::vector<MissedPair> missed;
};

/// Balanced RRT between random pairs of places of the largest area. Pair i depends on the seed and
/// on i alone. That there is a way between the two is proved, since they lie in one area.
PlanningTrials run_planning_trials(const FreeSpace& space, const TravelAreas& areas,
                                   const PlanningTrialsSettings& settings, std::uint64_t seed);

}  // namespace mapwright::navcore
