// Answers the queries of the verb plan.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/plan/places.hpp"
#include "cli/support/planners.hpp"
#include "navcore/exact/travel_areas.hpp"
#include "navcore/named_places.hpp"
#include "navcore/planning/route.hpp"
#include "navcore/reachability/reachability_map.hpp"

namespace mapwright::cli {

struct PlanSettings {
  std::string planner;
  double radius_m = 0.0;
  navcore::RampPolicy ramps = navcore::RampPolicy::kFree;
  bool force_ramp = false;  ///< the path must cross some ramp
  std::vector<ViaPlace> via;
  std::uint64_t seed = 1;
  navcore::RrtOptions rrt;
  std::optional<navcore::SmoothingOptions> smoothing = navcore::SmoothingOptions{};
};

struct PlanAnswer {
  StartAndGoal query;
  navcore::Route route;
  double length_m = 0.0;
  std::optional<double> min_clearance_m;  ///< nothing where nothing blocks in the map
  std::string reason;                     ///< why there is no path
};

/// Plans on one map. Safe to use from many threads.
class PlanSolver {
 public:
  /// `map` must outlive this. Throws Error (kUsage) for via-points that the map does not have.
  PlanSolver(const Map& map, const PlanSettings& settings);

  /// The query with the points that stand for its named places: free ground beside them, in the
  /// largest connected area where possible (PlaceFinder). Throws Error (kUsage) for names that the
  /// map does not have. One thread at a time.
  StartAndGoal located(const StartAndGoal& query) const;

  /// Query number `number` (its random numbers depend on it); it must be located.
  PlanAnswer answer(const StartAndGoal& query, std::size_t number) const;

 private:
  std::optional<std::string> why_not_standing(const StartAndGoal& query) const;
  navcore::Route route_through(const std::vector<Point>& stops, std::uint64_t seed) const;
  navcore::Route shortest_over_a_ramp(const std::vector<Point>& stops, std::uint64_t seed) const;
  std::vector<Point> resolved_via() const;
  std::vector<Point> resolved_ramps() const;
  void explain_failure(const std::vector<Point>& stops, PlanAnswer& answer) const;
  Place located(const Place& place) const;
  bool is_in_largest_area(Point p) const;
  const navcore::ReachabilityMap& reachability() const;

  const Map& map_;
  PlanSettings settings_;
  navcore::FreeSpace space_;
  navcore::PlaceFinder finder_;
  navcore::LegPlanner planner_;
  std::vector<Point> via_;
  std::vector<Point> ramps_;  // a point on each, where a path has to cross one
  mutable std::once_flag reachability_made_;
  mutable std::optional<navcore::ReachabilityMap> reachability_;
  mutable std::once_flag areas_made_;
  mutable std::optional<navcore::TravelAreas> areas_;  // nothing where they cannot be computed
};

}  // namespace mapwright::cli
