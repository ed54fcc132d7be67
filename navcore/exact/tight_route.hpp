// Private to this folder: Routes where an offset free space is cut and the true one is not.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::navcore::exact {

/// A stretch of a route.
struct Stretch {
  std::vector<Point> points;  ///< at least two
  /// Both ends lie in one connected part of the free space: any way through that part will do.
  bool is_within_part = false;
};

/// The number of the connected part of a free space that holds a point; nothing outside of it.
using PartAt = std::function<std::optional<std::uint32_t>(Point)>;

/// Cuts a route where it leaves a connected part of the free space for good, and where it comes to
/// the next one. Looks at places `step` apart. Stretches follow each other and cover the route.
/// Nothing where an end of the route lies in no part.
std::optional<std::vector<Stretch>> cut_route(const std::vector<Point>& route, double step,
                                              const PartAt& part_at);

/// Leaves out points as long as `is_clear` allows the straight way. Nothing where it forbids the
/// way from a point to the next.
std::optional<std::vector<Point>> pull_taut(const std::vector<Point>& points,
                                            const std::function<bool(Point, Point)>& is_clear);

}  // namespace mapwright::navcore::exact
