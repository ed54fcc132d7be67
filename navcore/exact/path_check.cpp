#include "navcore/exact/path_check.hpp"

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/exact/wall_passing.hpp"

namespace mapwright::navcore {
namespace {

double distance_to_segment(Point p, Point a, Point b) {
  return distance(p, closest_point_on_segment(p, a, b));
}

double distance_between(Point a, Point b, Point c, Point d) {
  if (meet(a, b, c, d).kind != Meeting::kNone) return 0.0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                   distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
}

double distance_to_border(const Border& border, Point p) {
  return std::min({p.x - border.left, border.right - p.x, p.y - border.bottom, border.top - p.y});
}

bool crosses_any(std::span<const BlockingSegment> segments, Point a, Point b) {
  return std::any_of(segments.begin(), segments.end(), [&](const BlockingSegment& segment) {
    return meet(a, b, segment.a, segment.b).kind == Meeting::kCross;
  });
}

}  // namespace

double least_distance_m(const Border& border, std::span<const BlockingSegment> segments,
                        std::span<const Point> path) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < path.size(); ++i) {
    least = std::min(least, distance_to_border(border, path[i]));
    const Point from = path[i == 0 ? 0 : i - 1];
    for (const auto& s : segments) {
      least = std::min(least, distance_between(from, path[i], s.a, s.b));
    }
  }
  return least;
}

bool is_path_clear(const Border& border, std::span<const BlockingSegment> segments,
                   std::span<const Point> path, double radius_m) {
  if (path.empty()) return false;
  constexpr double kNanometre_m = 1e-9;
  if (radius_m > 0.0) return least_distance_m(border, segments, path) >= radius_m - kNanometre_m;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!border.contains(path[i])) return false;
    if (i > 0 && crosses_any(segments, path[i - 1], path[i])) return false;
  }
  return !passes_where_it_touches(border, segments, path);
}

}  // namespace mapwright::navcore
