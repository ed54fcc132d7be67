// The parts of a map between which a robot cannot travel, and what keeps them apart.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "navcore/exact/exact_planner.hpp"

namespace mapwright::navcore {

/// A part of the places for the robot's centre that no way leads out of.
struct TravelArea {
  double area_m2 = 0.0;  ///< never too large; ExactPlanner::offset_error says what it may lack
  Point at;              ///< well within it
  Box box = kEmptyBox;
  /// What keeps the robot from the largest area: where the widest way there is too narrow. Nothing
  /// for the largest area itself, and where no disc gets out, however small.
  std::optional<Bottleneck> gap;
};

/// All of them for one map and one robot.
///
/// Areas come from the exact planner's mesh with 8 tangents a quarter circle; whether two of them
/// are connected is decided by the widths of the medial axis, which have no such error: a gap
/// exactly as wide as the robot lets it pass. Immutable; safe to use from many threads.
class TravelAreas {
 public:
  /// Areas smaller than this are not listed (m²).
  static constexpr double kLeastArea_m2 = 0.05;

  /// Failures: those of ExactPlanner::build.
  static Result<TravelAreas> build(const Map& map, double radius_m, RampPolicy ramps);

  /// For the radius of a planner that exists; it is kept.
  explicit TravelAreas(ExactPlanner planner, double radius_m);

  /// Largest first. Empty where the robot can stand nowhere.
  const std::vector<TravelArea>& areas() const { return areas_; }

  double free_area_m2() const { return free_area_m2_; }  ///< smallest areas included

  /// Share of the largest area in all free ground, in [0, 1]; 0 where there is none.
  double largest_fraction() const;

  /// Position in areas() of the area that p belongs to.
  std::optional<std::size_t> area_at(Point p) const;

  const ExactPlanner& planner() const { return planner_; }

 private:
  void add(const FreeComponent& component, std::size_t number, std::size_t group);
  void rank();

  ExactPlanner planner_;
  std::vector<TravelArea> areas_;
  std::vector<std::optional<std::size_t>> area_of_component_;
  double free_area_m2_ = 0.0;
};

}  // namespace mapwright::navcore
