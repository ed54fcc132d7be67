#include "converter/pipeline/ring_validity.hpp"

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

using Ring = std::vector<Point>;

struct Edge {
  Point a, b;
  std::size_t ring;
};

std::vector<Edge> edges_of(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({rings[r][i], rings[r][i + 1 == rings[r].size() ? 0 : i + 1], r});
    }
  }
  return edges;
}

bool rings_cross(const std::vector<Ring>& rings) {
  const auto edges = edges_of(rings);
  std::vector<Box> boxes;
  for (const auto& edge : edges) {
    Box box = kEmptyBox;
    box.add(edge.a);
    box.add(edge.b);
    boxes.push_back(box);
  }
  bool crossing = false;
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    if (crossing || edges[i].ring == edges[j].ring) return;
    const auto kind = meet(edges[i].a, edges[i].b, edges[j].a, edges[j].b).kind;
    crossing = kind == Meeting::kCross || kind == Meeting::kOverlap;
  });
  return crossing;
}

// Side of a ring that does not cross `outer`: vertices on the boundary say nothing.
PointSide side_of(const Ring& outer, const Ring& ring) {
  for (const Point p : ring) {
    const auto side = side_of_ring(outer, p);
    if (side != PointSide::kBoundary) return side;
  }
  return side_of_ring(outer, 0.5 * (ring[0] + ring[1]));
}

std::string hole_defect(const std::vector<Ring>& rings) {
  for (std::size_t i = 1; i < rings.size(); ++i) {
    if (side_of(rings[0], rings[i]) != PointSide::kInside)
      return "a hole lies outside of its outline";
    for (std::size_t j = 1; j < rings.size(); ++j) {
      if (i != j && side_of(rings[j], rings[i]) != PointSide::kOutside)
        return "a hole lies in another hole";
    }
  }
  return {};
}

}  // namespace

std::string polygon_defect(const std::vector<std::vector<Point>>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!is_simple_ring(rings[i])) {
      return i == 0 ? "an outline crosses or touches itself" : "a hole crosses or touches itself";
    }
  }
  if (rings.size() == 1) return {};
  if (rings_cross(rings)) return "rings of one polygon cross or overlap";
  return hole_defect(rings);
}

}  // namespace mapwright::converter
