#include "navcore/exact/gap.hpp"

#include <algorithm>
#include <cmath>

namespace mapwright::navcore::exact {
namespace {

__extension__ using Wide = __int128;

Point to_point(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

double length_of_segment_squared(const VoronoiSite& s) {
  return static_cast<double>(squared_distance(s.a, s.b));
}

// Distance of p to the line of a segment, from the exact square of the area it spans with it.
double distance_to_line_mm(GridPoint p, const VoronoiSite& s) {
  const std::int64_t area = orient(s.a, s.b, p);
  return std::sqrt(static_cast<double>(Wide{area} * area) / length_of_segment_squared(s));
}

std::optional<Gap> gap_to_segment(const VoronoiSite& point, const VoronoiSite& segment) {
  const GridPoint p = point.a;
  if (p == segment.a || p == segment.b) return std::nullopt;
  if (dot_from(segment.a, segment.b, p) < 0 || dot_from(segment.b, segment.a, p) < 0) {
    return std::nullopt;
  }
  return Gap{to_point(p), foot_on_line(to_point(p), segment), distance_to_line_mm(p, segment)};
}

// In the middle of the stretch along which the two face each other.
std::optional<Gap> gap_of_parallels(const VoronoiSite& p, const VoronoiSite& q) {
  const Wide px = std::int64_t{p.b.x} - p.a.x, py = std::int64_t{p.b.y} - p.a.y;
  const Wide qx = std::int64_t{q.b.x} - q.a.x, qy = std::int64_t{q.b.y} - q.a.y;
  if (px * qy != py * qx || orient(p.a, p.b, q.a) == 0) return std::nullopt;
  const double along_a = static_cast<double>(dot_from(p.a, p.b, q.a));
  const double along_b = static_cast<double>(dot_from(p.a, p.b, q.b));
  const double whole = length_of_segment_squared(p);
  const double from = std::max(0.0, std::min(along_a, along_b));
  const double to = std::min(whole, std::max(along_a, along_b));
  if (from > to) return std::nullopt;
  const double t = 0.5 * (from + to) / whole;
  const Point on_p = to_point(p.a) + t * (to_point(p.b) - to_point(p.a));
  return Gap{on_p, foot_on_line(on_p, q), distance_to_line_mm(q.a, p)};
}

}  // namespace

Point foot_on_line(Point p, const VoronoiSite& segment) {
  const Point a = to_point(segment.a), d = to_point(segment.b) - a;
  return a + (dot(p - a, d) / squared_length(d)) * d;
}

std::optional<Gap> gap_between(const VoronoiSite& p, const VoronoiSite& q) {
  if (p.is_point() && q.is_point()) {
    if (p.a == q.a) return std::nullopt;
    return Gap{to_point(p.a), to_point(q.a), distance_mm(p.a, q.a)};
  }
  if (p.is_point()) return gap_to_segment(p, q);
  if (q.is_point()) {
    auto gap = gap_to_segment(q, p);
    if (gap) std::swap(gap->from, gap->to);
    return gap;
  }
  return gap_of_parallels(p, q);
}

}  // namespace mapwright::navcore::exact
