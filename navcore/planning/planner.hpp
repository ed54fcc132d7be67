// Planners that grow random trees (report, section 4.2, figure 7).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/random.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

/// From where to where, and how big the robot is. Metres, map frame.
struct PlanQuery {
  Point start, goal;
  double radius_m = 0.0;  ///< of the robot, a disc; 0 for the report's point robot
};

/// The defaults are the report's planner; what makes larger maps easier is an option.
struct RrtOptions {
  std::size_t max_iterations = 100000;  ///< random points drawn, then the planner gives up
  double max_extension_m = 0.0;  ///< longest new edge; 0: as long as the way to the point is free
  double goal_bias = 0.0;        ///< share of the points, in [0, 1), that are the goal itself
};

struct TreeEdge {
  Point from, to;
};

/// What a planner found. A planner that gave up proves nothing.
struct PlanningResult {
  bool solved = false;
  std::vector<Point> path;  ///< start … goal, at least two points; empty where not solved
  std::size_t iterations = 0;
  std::vector<TreeEdge> tree;  ///< all edges that were grown, of both trees where there are two

  // What only planners that prove their answer say.
  bool is_shortest = false;            ///< smoothing would only spoil the path
  std::optional<bool> reachable;       ///< whether there is a way at all
  std::optional<double> bottleneck_m;  ///< width (diameter) of the widest way's narrowest place
  std::optional<Point> bottleneck_at;
  std::string reason;             ///< why it cannot tell
  std::string caution;            ///< what was not taken as the map has it, and where
  std::vector<TreeEdge> barrier;  ///< where there is no way: a closed polygon that proves it
};

/// RRT: a tree grows from the start. In each iteration a random free point is drawn and connects
/// directly to the tree, that is to the nearest of the nodes it sees; done as soon as the goal
/// sees a new node. "Sees": the disc moves there straight. Of the tree the 16 nearest nodes are
/// tried (docs/decisions/0041-direct-connection.md).
///
/// Requires start and goal free for the radius. Same query, options and state of `random`: same
/// result.
PlanningResult plan_rrt(const FreeSpace& space, const PlanQuery& query, const RrtOptions& options,
                        Random& random);

/// Balanced RRT: two trees, one from the start and one from the goal, grow in turns; done as soon
/// as a new node of one sees a node of the other. Otherwise as `plan_rrt`.
PlanningResult plan_balanced_rrt(const FreeSpace& space, const PlanQuery& query,
                                 const RrtOptions& options, Random& random);

}  // namespace mapwright::navcore
