#include "mapcore/defect_geometry.hpp"

#include <algorithm>
#include <iterator>

namespace mapwright {
namespace {

constexpr std::size_t kLeastCorners = 3;

template <class Part>
void append(std::vector<Part>& parts, std::vector<Part>& others) {
  parts.insert(parts.end(), std::make_move_iterator(others.begin()),
               std::make_move_iterator(others.end()));
}

}  // namespace

DefectGeometry geometry_of(const Segment& segment) {
  if (segment.a == segment.b) return {{segment.a}, {}, {}};
  return {{}, {{segment.a, segment.b}}, {}};
}

DefectGeometry geometry_of(std::span<const Segment> segments) {
  DefectGeometry geometry;
  bool joins = false;
  for (const auto& segment : segments) {
    if (segment.a == segment.b) {
      geometry.points.push_back(segment.a);
      continue;
    }
    joins = joins && geometry.lines.back().back() == segment.a;
    if (!joins) geometry.lines.push_back({segment.a});
    geometry.lines.back().push_back(segment.b);
    joins = true;
  }
  return geometry;
}

DefectGeometry geometry_of(const Obstacle& obstacle) {
  DefectGeometry geometry = geometry_of(obstacle.segments);
  if (!is_closed(obstacle.shape_type) || geometry.lines.size() != 1) return geometry;
  auto& ring = geometry.lines.front();
  if (ring.size() <= kLeastCorners || ring.front() != ring.back()) return geometry;
  ring.pop_back();
  return {{}, {}, std::move(geometry.lines)};
}

DefectGeometry geometry_of(const Border& border) {
  const std::vector<Point> corners{{border.left, border.bottom},
                                   {border.right, border.bottom},
                                   {border.right, border.top},
                                   {border.left, border.top}};
  if (border.left != border.right && border.bottom != border.top) return {{}, {}, {corners}};
  return geometry_of(Segment{corners[0], corners[2], 0.0, {}, {}});
}

void append(DefectGeometry& geometry, DefectGeometry other) {
  append(geometry.points, other.points);
  append(geometry.lines, other.lines);
  append(geometry.areas, other.areas);
}

}  // namespace mapwright
