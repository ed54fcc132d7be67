// Planning that proves its answer.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/result.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// The robot, and how it meets the map.
struct ExactOptions {
  double radius_m = 0.0;  ///< of the disc; 0 for a point
  RampPolicy ramps = RampPolicy::kFree;
  int tangents_a_quadrant = 2;  ///< sides for a quarter circle around corners, 1 to 64
};

/// Whether the robot can stand at a place.
enum class PlaceState {
  kFree,
  kNotFinite,      ///< a coordinate is no number
  kOutsideBorder,  ///< beyond the border
  kBlocked,        ///< inside of a solid, or nearer to an obstacle or the border than the radius
};

/// "inside of an obstacle or too near to one", for messages.
std::string_view to_string(PlaceState state);

enum class Verdict {
  kReachable,
  kUnreachable,
  /// Neither a path nor a barrier passed its check. On maps whose walls lie on the grid that means
  /// a gap within 2 nm of the robot's width; else the robot fits, or does not, by less than the
  /// snapping error (snapping_error_m).
  kUndecided,
};

/// A straight part of a barrier (metres, map frame).
struct BarrierSide {
  Point from, to;
  bool is_gap = false;  ///< across a gap narrower than the robot; otherwise along an obstacle
  /// Positions in Map::obstacles of what it begins and ends at; nothing for the border.
  std::optional<std::uint32_t> obstacle_from, obstacle_to;
};

struct ExactAnswer {
  PlaceState start = PlaceState::kFree, goal = PlaceState::kFree;
  Verdict verdict = Verdict::kUnreachable;

  /// The Euclidean shortest path, start first; empty where there is none. For a disc: the shortest
  /// within the offset free space (docs/exact-planning.md states its bound). Where that is cut by
  /// gaps less than 3 mm wider than the disc: shortest paths from gap to gap, and the medial axis
  /// through each.
  std::vector<Point> path;
  double length_m = 0.0;

  /// Where both places are free and not connected: a closed polygon that the robot cannot cross and
  /// that separates them, checked with integers (exact/barrier.hpp).
  std::vector<BarrierSide> barrier;
};

/// Where the widest way between two places is narrowest (metres, map frame).
struct Bottleneck {
  double width_m = 0.0;  ///< diameter of the largest disc that travels from the one to the other
  Point at;              ///< where its centre is there
  Point from, to;        ///< nearest points of the two obstacles that make the gap
  /// Positions of those in Map::obstacles; nothing for the border.
  std::optional<std::uint32_t> obstacle_from, obstacle_to;
  /// Positions of their segments in Obstacle::segments; nothing for the border and the flanks of
  /// stairs.
  std::optional<std::uint32_t> segment_from, segment_to;
  /// Nowhere on the way is it narrower than at start or goal: `at` is that place, and `from` and
  /// `to` are both the point nearest to it.
  bool is_end = false;
};

/// A connected part of the free space.
struct FreeComponent {
  double area_m2 = 0.0;
  Point somewhere;      ///< the middle of its largest convex cell
  Box box = kEmptyBox;  ///< around all of it
};

/// Memory of a search, kept between queries; one per thread.
class ExactWorkspace {
 public:
  ExactWorkspace();
  ExactWorkspace(ExactWorkspace&&) noexcept;
  ExactWorkspace& operator=(ExactWorkspace&&) noexcept;
  ~ExactWorkspace();

 private:
  friend class ExactPlanner;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Shortest paths and proofs of absence for one map and one robot. Everything is computed on a grid
/// of millimetres with exact integer predicates; docs/exact-planning.md says what follows for maps
/// that are not on that grid. Immutable once built; safe to use from many threads.
///
/// For a point robot free space is closed: a path may touch outlines and run along them, but passes
/// no wall, also not at a point where two of them touch.
class ExactPlanner {
 public:
  /// Failures: a border without area or with numbers that are not finite, an obstacle more than
  /// 500 km from the border's centre, a radius that is negative or no number.
  static Result<ExactPlanner> build(const Map& map, const ExactOptions& options);

  /// A planner for another radius. It shares what does not depend on the radius, so it costs only
  /// the offset. Failures: a radius that is negative or no number.
  Result<ExactPlanner> with_radius(double radius_m) const;

  ExactPlanner(ExactPlanner&&) noexcept;
  ExactPlanner& operator=(ExactPlanner&&) noexcept;
  ~ExactPlanner();

  PlaceState state(Point p) const;
  ExactAnswer plan(Point start, Point goal) const;
  ExactAnswer plan(Point start, Point goal, ExactWorkspace& workspace) const;

  /// The narrowest place of the widest way between two places that are free for a point, whatever
  /// the planner's radius. Nothing where a place lies on an outline, or no disc travels, however
  /// small. The first call builds the medial axis of the map; later ones take logarithmic time.
  std::optional<Bottleneck> bottleneck(Point a, Point b) const;

  /// Tells places apart between which a disc of `radius_m` cannot travel, whatever the planner's
  /// own radius and without the error of its offset: it can travel from the one to the other if and
  /// only if both give the same number (walls taken as they are on the grid). Requires places free
  /// for a disc of that radius; nothing where a place lies on an outline or beyond the border. The
  /// number means nothing else. As `bottleneck`, the first call builds the medial axis.
  std::optional<std::size_t> region_at(Point p, double radius_m) const;

  /// Connected parts of the robot's free space (of its centre), largest first.
  std::vector<FreeComponent> components() const;
  /// Number of the component that holds p, as in components(); nothing where p is not free.
  std::optional<std::size_t> component_at(Point p) const;

  /// How far a wall may have been moved by rounding to the grid and cutting walls where they cross,
  /// metres; 0 for maps written in millimetres whose walls meet at such points.
  double snapping_error_m() const;

  /// The end of a segment moved farthest by rounding, or else the first crossing off the grid;
  /// nothing where snapping_error_m() is 0.
  std::optional<Point> snapped_at() const;

  /// What the disc's free space may lack beside the true one, metres: `at_corners_m` around convex
  /// corners, `elsewhere_m` along walls. It never has too much. 0 for a point.
  struct OffsetError {
    double at_corners_m = 0.0, elsewhere_m = 0.0;
  };
  OffsetError offset_error() const;

 private:
  struct Impl;
  explicit ExactPlanner(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::navcore
