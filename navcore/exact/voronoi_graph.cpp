#include "navcore/exact/voronoi_graph.hpp"

#include <numeric>

#include "navcore/exact/voronoi_diagram.hpp"

namespace mapwright::navcore::exact {
namespace {

// Edges of the line work with free space on at least one side.
std::vector<std::uint32_t> bounding_edges(const Tessellation& space) {
  std::vector<char> bounds(space.work.edges.size());
  for (std::size_t t = 0; t < space.triangles.size(); ++t) {
    if (space.is_free[t] == 0) continue;
    for (const std::int32_t edge : space.triangles[t].edge) {
      if (edge >= 0) bounds[static_cast<std::size_t>(edge)] = 1;
    }
  }
  std::vector<std::uint32_t> edges;
  for (std::uint32_t edge = 0; edge < bounds.size(); ++edge) {
    if (bounds[edge] != 0) edges.push_back(edge);
  }
  return edges;
}

void add_edges(const VoronoiDiagram& diagram, VoronoiGraph& graph) {
  const auto& edges = diagram.diagram().edges();
  graph.edges.reserve(edges.size() / 2);
  for (std::size_t i = 0; i < edges.size(); i += 2) {  // twins follow each other
    const auto& edge = edges[i];
    if (!VoronoiDiagram::is_inner(edge)) continue;
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
    : work_(space.work), edges_(bounding_edges(space)) {
  if (edges_.empty()) return;
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const std::uint32_t edge : edges_) {
    const GridPoint a = work_.vertices[work_.edges[edge].a],
                    b = work_.vertices[work_.edges[edge].b];
    builder.insert_segment(a.x, a.y, b.x, b.y);
  }
  builder.construct(&diagram_);
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
