// The collision test in so many words: every blocking segment against every leg.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/free_space.hpp"

namespace mapwright::test {

/// Least distance between a leg and all blocking segments; 0 where they meet.
inline double slow_clearance_m(const std::vector<navcore::BlockingSegment>& segments,
                               const std::vector<Point>& path) {
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path[i - 1];
    const Point b = path[i];
    for (const auto& s : segments) {
      if (meet(a, b, s.a, s.b).kind != Meeting::kNone) return 0.0;
      least = std::min({least, distance(a, closest_point_on_segment(a, s.a, s.b)),
                        distance(b, closest_point_on_segment(b, s.a, s.b)),
                        distance(s.a, closest_point_on_segment(s.a, a, b)),
                        distance(s.b, closest_point_on_segment(s.b, a, b))});
    }
  }
  return least;
}

}  // namespace mapwright::test
