#include "navcore/exact/voronoi_graph.hpp"

#include <numeric>

#include "navcore/exact/voronoi_diagram.hpp"
#include "navcore/exact/voronoi_numbers.hpp"

namespace mapwright::navcore::exact {
namespace {

constexpr char kLeft = 1, kRight = 2;

// On which sides of each edge of the line work (a to b) free space lies.
std::vector<char> free_sides(const Tessellation& space) {
  std::vector<char> sides(space.work.edges.size());
  for (std::size_t t = 0; t < space.triangles.size(); ++t) {
    if (space.is_free[t] == 0) continue;
    const Triangle& triangle = space.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {  // corners run counter-clockwise
      if (triangle.edge[i] < 0) continue;
      const auto edge = static_cast<std::size_t>(triangle.edge[i]);
      sides[edge] |= triangle.corner[i] == space.work.edges[edge].a ? kLeft : kRight;
    }
  }
  return sides;
}

void add_edges(const VoronoiDiagram& diagram, VoronoiGraph& graph) {
  const auto& edges = diagram.diagram().edges();
  graph.edges.reserve(edges.size() / 2);
  for (std::size_t i = 0; i < edges.size(); i += 2) {  // twins follow each other
    const auto& edge = edges[i];
    if (!diagram.is_inner(edge)) continue;
    graph.edges.push_back({diagram.number_of(edge.vertex0()), diagram.number_of(edge.vertex1()),
                           diagram.number_of(edge.cell()), diagram.number_of(edge.twin()->cell())});
  }
}

void group_edges_by_site(VoronoiGraph& graph) {
  graph.first_edge.assign(graph.sites.size() + 1, 0);
  for (const VoronoiEdge& edge : graph.edges) {
    ++graph.first_edge[edge.first_site + 1];
    ++graph.first_edge[edge.second_site + 1];
  }
  std::partial_sum(graph.first_edge.begin(), graph.first_edge.end(), graph.first_edge.begin());
  graph.edges_of_sites.resize(graph.first_edge.back());
  std::vector<std::uint32_t> next(graph.first_edge.begin(), graph.first_edge.end() - 1);
  for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
    graph.edges_of_sites[next[graph.edges[i].first_site]++] = i;
    graph.edges_of_sites[next[graph.edges[i].second_site]++] = i;
  }
}

}  // namespace

double distance_to(const VoronoiSite& site, Point p) {
  const Point a{static_cast<double>(site.a.x), static_cast<double>(site.a.y)};
  const Point b{static_cast<double>(site.b.x), static_cast<double>(site.b.y)};
  return distance(p, closest_point_on_segment(p, a, b));
}

VoronoiDiagram::VoronoiDiagram(const Tessellation& space)
    : work_(space.work), free_sides_(free_sides(space)) {
  for (std::uint32_t edge = 0; edge < free_sides_.size(); ++edge) {
    if (free_sides_[edge] != 0) edges_.push_back(edge);
  }
  if (edges_.empty()) return;
  boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers> builder;
  for (const std::uint32_t edge : edges_) {
    const GridPoint a = work_.vertices[work_.edges[edge].a],
                    b = work_.vertices[work_.edges[edge].b];
    builder.insert_segment(a.x, a.y, b.x, b.y);
  }
  builder.construct(&diagram_);
}

bool VoronoiDiagram::is_beside_free_side(const HalfEdge& edge, const Cell& cell) const {
  if (!cell.contains_segment()) return true;
  const std::uint32_t number = edges_[cell.source_index()];
  if (free_sides_[number] == (kLeft | kRight)) return true;
  const GridPoint a = work_.vertices[work_.edges[number].a],
                  b = work_.vertices[work_.edges[number].b];
  const Point from{static_cast<double>(a.x), static_cast<double>(a.y)};
  const Point along{static_cast<double>(b.x) - from.x, static_cast<double>(b.y) - from.y};
  const Point middle{0.5 * (edge.vertex0()->x() + edge.vertex1()->x()),
                     0.5 * (edge.vertex0()->y() + edge.vertex1()->y())};
  const double side = cross(along, middle - from);
  return free_sides_[number] == kLeft ? side >= 0.0 : side <= 0.0;
}

VoronoiSite VoronoiDiagram::site_of(const Cell& cell) const {
  const std::uint32_t number = edges_[cell.source_index()];
  const Edge& edge = work_.edges[number];
  const GridPoint a = work_.vertices[edge.a], b = work_.vertices[edge.b];
  switch (cell.source_category()) {
    case boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT:
      return {a, a, number};
    case boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT:
      return {b, b, number};
    default:
      return {a, b, number};
  }
}

VoronoiGraph build_voronoi_graph(const Tessellation& space) {
  const VoronoiDiagram voronoi(space);
  const auto& diagram = voronoi.diagram();
  VoronoiGraph graph;
  graph.vertices.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) graph.vertices.push_back({vertex.x(), vertex.y()});
  graph.sites.reserve(diagram.num_cells());
  for (const auto& cell : diagram.cells()) graph.sites.push_back(voronoi.site_of(cell));
  add_edges(voronoi, graph);
  group_edges_by_site(graph);
  return graph;
}

}  // namespace mapwright::navcore::exact
