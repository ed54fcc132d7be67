#include "mapcore/geometry/ring_union.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <stdexcept>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Ring = CGAL::Polygon_2<Kernel>;
using Area = CGAL::Polygon_with_holes_2<Kernel>;

// CGAL wants outlines counter-clockwise and holes clockwise.
Ring ring_of(const std::vector<Point>& points, CGAL::Orientation wanted) {
  Ring ring;
  for (const Point p : points) ring.push_back({p.x, p.y});
  if (ring.orientation() != wanted) ring.reverse_orientation();
  return ring;
}

Area area_of(const SimplePolygon& polygon) {
  Area area(ring_of(polygon.outer, CGAL::COUNTERCLOCKWISE));
  for (const auto& hole : polygon.holes) area.add_hole(ring_of(hole, CGAL::CLOCKWISE));
  return area;
}

std::vector<Point> points_of(const Ring& ring, const Snap& snap) {
  std::vector<Point> points;
  for (const auto& p : ring.vertices()) {
    const Point q = snap({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
    if (points.empty() || points.back() != q) points.push_back(q);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

std::vector<std::vector<Point>> rings_of(const Area& area, const Snap& snap) {
  std::vector<std::vector<Point>> rings{points_of(area.outer_boundary(), snap)};
  for (const auto& hole : area.holes()) rings.push_back(points_of(hole, snap));
  std::erase_if(rings, [](const std::vector<Point>& ring) { return ring.size() < 3; });
  return rings;
}

// Vertices that only marked where a wall between two polygons began.
void drop_straight_vertices(std::vector<Point>& ring) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point before = corners.empty() ? ring.back() : corners.back();
    const Point after = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (turn(before, ring[i], after) != Turn::kStraight) corners.push_back(ring[i]);
  }
  ring = std::move(corners);
}

}  // namespace

std::optional<std::vector<SimplePolygon>> united_polygons(std::span<const SimplePolygon> polygons,
                                                          const Snap& snap) {
  std::vector<Area> areas;
  for (const auto& polygon : polygons) areas.push_back(area_of(polygon));
  CGAL::Polygon_set_2<Kernel> together;
  try {
    together.join(areas.begin(), areas.end());
  } catch (const std::logic_error&) {  // a precondition of CGAL: rings that touch each other
    return std::nullopt;
  }
  std::vector<Area> united;
  together.polygons_with_holes(std::back_inserter(united));
  std::vector<std::vector<Point>> rings;
  for (const Area& area : united) {
    for (auto& ring : rings_of(area, snap)) rings.push_back(std::move(ring));
  }
  // Disjoint areas with holes are what the odd-even rule makes of their rings; it also mends what
  // rounding has made touch.
  auto mended = odd_even_polygons(rings, snap);
  if (!mended) return std::nullopt;
  for (auto& polygon : *mended) {
    drop_straight_vertices(polygon.outer);
    for (auto& hole : polygon.holes) drop_straight_vertices(hole);
  }
  return mended;
}

}  // namespace mapwright
