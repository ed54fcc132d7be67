// Shorter ways along the same path.
#pragma once

#include <cstddef>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/random.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

struct SmoothingOptions {
  std::size_t tries = 200;  ///< random shortcuts tried, and as many as the path has points
  /// What a shortcut keeps away from obstacles, beyond the robot's radius; where the path itself is
  /// nearer, it stays as it is.
  double extra_clearance_m = 0.0;
};

/// The path (report, figure 8: "the resultant smoothed path") with shortcuts: vertices that can be
/// passed over are, random pairs of points along the path are joined where the disc can move
/// straight from one to the other, and what corners remain are cut.
///
/// Same ends; never longer; every leg was checked as `FreeSpace::is_free_way` does. Requires a path
/// that is free for the radius.
std::vector<Point> smooth_path(const FreeSpace& space, std::vector<Point> path, double radius_m,
                               const SmoothingOptions& options, Random& random);

}  // namespace mapwright::navcore
