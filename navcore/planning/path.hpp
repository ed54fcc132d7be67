// What can be said of a path.
#pragma once

#include <optional>
#include <span>

#include "mapcore/point.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::navcore {

double path_length_m(std::span<const Point> path);

/// Least distance between the path and what blocks it, over the whole of each leg and not only its
/// ends; 0 where it touches. Nothing where nothing blocks in the map, or for an empty path. The
/// border does not count.
std::optional<double> path_clearance_m(const FreeSpace& space, std::span<const Point> path);

/// True if the disc follows the path without meeting anything.
bool is_free_path(const FreeSpace& space, std::span<const Point> path, double radius_m);

}  // namespace mapwright::navcore
