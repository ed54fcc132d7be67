#include "mapcore/geometry/ring_repair.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

struct FaceLabel {
  int component = -1;  // of the covered area; −1: not covered
  bool seen = false;
};

using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceLabel, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_intersections_tag>>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;
using Edge = Triangulation::Edge;

constexpr int kMostRounds = 8;

Triangulation triangulate(std::span<const std::vector<Point>> rings) {
  Triangulation triangulation;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a == b) continue;
      triangulation.insert_constraint(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y));
    }
  }
  return triangulation;
}

// Edges that rings run along an even number of times have the same area on both sides.
bool separates(const Triangulation& triangulation, const Edge& edge) {
  if (!triangulation.is_constrained(edge)) return false;
  const auto a = edge.first->vertex(Triangulation::cw(edge.second));
  const auto b = edge.first->vertex(Triangulation::ccw(edge.second));
  return triangulation.number_of_enclosing_constraints(a, b) % 2 == 1;
}

// Gives every face its component. Faces reached without crossing a separating edge belong together;
// crossing one leads from covered to not covered and back.
class Labeller {
 public:
  explicit Labeller(Triangulation& triangulation) : triangulation_(triangulation) {}

  int label() {
    std::vector<std::pair<Face, bool>> seeds{{triangulation_.infinite_face(), false}};
    while (!seeds.empty()) {
      const auto [face, covered] = seeds.back();
      seeds.pop_back();
      if (!face->info().seen) flood(face, covered, seeds);
    }
    return components_;
  }

 private:
  void flood(Face start, bool covered, std::vector<std::pair<Face, bool>>& seeds) {
    const int component = covered ? components_++ : -1;
    std::vector<Face> open{start};
    start->info() = {component, true};
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face neighbour = face->neighbor(i);
        if (neighbour->info().seen) continue;
        if (separates(triangulation_, {face, i})) {
          seeds.emplace_back(neighbour, !covered);
        } else {
          neighbour->info() = {component, true};
          open.push_back(neighbour);
        }
      }
    }
  }

  Triangulation& triangulation_;
  int components_ = 0;
};

Point rounded(const Vertex& vertex, const Snap& snap) {
  return snap({CGAL::to_double(vertex->point().x()), CGAL::to_double(vertex->point().y())});
}

bool is_border(const Edge& edge) {
  return edge.first->info().component >= 0 &&
         edge.first->info().component != edge.first->neighbor(edge.second)->info().component;
}

// The border edge that follows: turning around the end vertex, through covered faces only.
Edge following(Edge edge) {
  Face face = edge.first;
  const Vertex end = face->vertex(Triangulation::cw(edge.second));
  while (true) {
    const Edge candidate{face,
                         Triangulation::cw(face->index(end))};  // leaves `end`, face on its left
    if (is_border(candidate)) return candidate;
    face = face->neighbor(candidate.second);
  }
}

using Ring = std::vector<Point>;

// Cuts a walk into rings in which no vertex comes twice.
void append_rings(const Ring& walk, std::vector<Ring>& rings) {
  const auto less = [](Point p, Point q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); };
  std::map<Point, std::size_t, decltype(less)> place(less);
  Ring open;
  for (const Point p : walk) {
    const auto before = place.find(p);
    if (before == place.end()) {
      place.emplace(p, open.size());
      open.push_back(p);
      continue;
    }
    const auto begin = open.begin() + static_cast<std::ptrdiff_t>(before->second);
    rings.emplace_back(begin, open.end());
    for (auto it = begin + 1; it != open.end(); ++it) place.erase(*it);
    open.erase(begin + 1, open.end());
  }
  rings.push_back(std::move(open));
}

// Walks all borders of the covered area, which lies on their left.
std::vector<std::vector<Ring>> border_rings(Triangulation& triangulation, const Snap& snap) {
  std::vector<std::vector<Ring>> rings(static_cast<std::size_t>(Labeller(triangulation).label()));
  std::map<std::pair<Face, int>, bool> walked;
  for (const Face start : triangulation.all_face_handles()) {
    for (int i = 0; i < 3; ++i) {
      if (!is_border({start, i}) || walked[{start, i}]) continue;
      Ring walk;
      for (Edge edge{start, i}; !walked[edge]; edge = following(edge)) {
        walked[edge] = true;
        const Point p = rounded(edge.first->vertex(Triangulation::ccw(edge.second)), snap);
        if (walk.empty() || walk.back() != p) walk.push_back(p);
      }
      while (walk.size() > 1 && walk.front() == walk.back()) walk.pop_back();
      append_rings(walk, rings[static_cast<std::size_t>(start->info().component)]);
    }
  }
  return rings;
}

std::vector<SimplePolygon> polygons_of(std::vector<std::vector<Ring>> components) {
  std::vector<SimplePolygon> polygons;
  for (auto& rings : components) {
    SimplePolygon polygon;
    for (auto& ring : rings) {
      switch (ring_orientation(ring)) {
        case RingOrientation::kCounterClockwise:
          polygon.outer = std::move(ring);
          break;
        case RingOrientation::kClockwise:
          polygon.holes.push_back(std::move(ring));
          break;
        case RingOrientation::kDegenerate:
          break;
      }
    }
    if (!polygon.outer.empty()) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

bool all_simple(const std::vector<SimplePolygon>& polygons) {
  return std::all_of(polygons.begin(), polygons.end(), [](const SimplePolygon& polygon) {
    return is_simple_ring(polygon.outer) &&
           std::all_of(polygon.holes.begin(), polygon.holes.end(),
                       [](const Ring& hole) { return is_simple_ring(hole); });
  });
}

// From the lowest and then leftmost vertex, so that the answer does not depend on the
// triangulation.
void start_at_lowest(Ring& ring) {
  std::rotate(
      ring.begin(),
      std::min_element(ring.begin(), ring.end(),
                       [](Point p, Point q) { return std::tie(p.y, p.x) < std::tie(q.y, q.x); }),
      ring.end());
}

void bring_into_order(std::vector<SimplePolygon>& polygons) {
  const auto less = [](const Ring& p, const Ring& q) {
    return std::tie(p[0].y, p[0].x, p[1].y, p[1].x) < std::tie(q[0].y, q[0].x, q[1].y, q[1].x);
  };
  for (auto& polygon : polygons) {
    start_at_lowest(polygon.outer);
    for (auto& hole : polygon.holes) start_at_lowest(hole);
    std::sort(polygon.holes.begin(), polygon.holes.end(), less);
  }
  std::sort(polygons.begin(), polygons.end(),
            [&](const auto& p, const auto& q) { return less(p.outer, q.outer); });
}

std::vector<Ring> all_rings(const std::vector<SimplePolygon>& polygons) {
  std::vector<Ring> rings;
  for (const auto& polygon : polygons) {
    rings.push_back(polygon.outer);
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return rings;
}

}  // namespace

std::optional<std::vector<SimplePolygon>> odd_even_polygons(
    std::span<const std::vector<Point>> rings, const Snap& snap) {
  std::vector<Ring> current(rings.begin(), rings.end());
  for (int round = 0; round < kMostRounds; ++round) {
    Triangulation triangulation = triangulate(current);
    if (triangulation.dimension() < 2) return std::vector<SimplePolygon>{};
    auto polygons = polygons_of(border_rings(triangulation, snap));
    if (all_simple(polygons)) {
      bring_into_order(polygons);
      return polygons;
    }
    current = all_rings(polygons);
  }
  return std::nullopt;
}

}  // namespace mapwright
