#include "converter/pipeline/ring_validity.hpp"

#include <map>
#include <numeric>
#include <set>
#include <tuple>

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

struct PointOrder {
  bool operator()(Point p, Point q) const { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }
};

// Where rings meet each other: which of them touch at which points, and whether they do worse.
struct Contacts {
  bool crossing = false;
  std::map<Point, std::set<std::size_t>, PointOrder> touches;
};

// The end of an edge at which two edges touch.
Point touching_end(const Edge& p, const Edge& q, Point near) {
  Point best = p.a;
  for (const Point end : {p.b, q.a, q.b}) {
    if (squared_length(end - near) < squared_length(best - near)) best = end;
  }
  return best;
}

Contacts contacts_of(const std::vector<Ring>& rings) {
  const auto edges = edges_of(rings);
  std::vector<Box> boxes;
  for (const auto& edge : edges) {
    Box box = kEmptyBox;
    box.add(edge.a);
    box.add(edge.b);
    boxes.push_back(box);
  }
  Contacts contacts;
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    if (contacts.crossing || edges[i].ring == edges[j].ring) return;
    const auto meeting = meet(edges[i].a, edges[i].b, edges[j].a, edges[j].b);
    contacts.crossing = meeting.kind == Meeting::kCross || meeting.kind == Meeting::kOverlap;
    if (meeting.kind != Meeting::kTouch) return;
    auto& there = contacts.touches[touching_end(edges[i], edges[j], meeting.at)];
    there.insert({edges[i].ring, edges[j].ring});
  });
  return contacts;
}

// Rings and the points where they touch are the nodes of a graph: a closed way in it goes around a
// piece of the inside (OGC 06-103r4, 6.1.11: the interior of a polygon is connected).
bool cuts_the_inside(const Contacts& contacts, std::size_t rings) {
  std::vector<std::size_t> parent(rings + contacts.touches.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  std::size_t point = rings;
  for (const auto& [place, touching] : contacts.touches) {
    for (const auto ring : touching) {
      const auto p = root(point), q = root(ring);
      if (p == q) return true;
      parent[p] = q;
    }
    ++point;
  }
  return false;
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
  const auto contacts = contacts_of(rings);
  if (contacts.crossing) return "rings of one polygon cross or overlap";
  const auto defect = hole_defect(rings);
  if (!defect.empty()) return defect;
  return cuts_the_inside(contacts, rings.size()) ? "holes cut the polygon's inside into pieces"
                                                 : "";
}

namespace {

// Whether a vertex or the middle of an edge lies on that side.
bool has_point(const Ring& ring, const Ring& other, PointSide side) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point next = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (side_of_ring(other, ring[i]) == side) return true;
    if (side_of_ring(other, 0.5 * (ring[i] + next)) == side) return true;
  }
  return false;
}

// Whether a ring inside of a polygon's outline is not wholly in one of its holes.
bool covers(const std::vector<Ring>& polygon, const Ring& ring) {
  if (side_of(polygon[0], ring) != PointSide::kInside) return false;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    if (side_of(polygon[i], ring) == PointSide::kInside) {
      return has_point(ring, polygon[i], PointSide::kOutside);
    }
  }
  return true;
}

}  // namespace

std::string parts_defect(const std::vector<std::vector<Ring>>& polygons) {
  if (polygons.size() < 2) return {};
  std::vector<Ring> outers;
  std::vector<Box> boxes;
  for (const auto& polygon : polygons) {
    outers.push_back(polygon[0]);
    Box box = kEmptyBox;
    for (const Point p : polygon[0]) box.add(p);
    boxes.push_back(box);
  }
  if (contacts_of(outers).crossing) return "parts of it overlap or share an edge";
  bool nested = false;
  for_each_meeting_pair(boxes, [&](std::size_t i, std::size_t j) {
    nested = nested || covers(polygons[i], outers[j]) || covers(polygons[j], outers[i]);
  });
  return nested ? "a part of it lies in another" : "";
}

}  // namespace mapwright::converter
