#include "navcore/exact/voronoi_graph.hpp"

#include <boost/polygon/voronoi.hpp>
#include <numeric>

namespace mapwright::navcore::exact {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;

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

void sweep(const LineWork& work, const std::vector<std::uint32_t>& edges, Diagram& diagram) {
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const std::uint32_t edge : edges) {
    const GridPoint a = work.vertices[work.edges[edge].a], b = work.vertices[work.edges[edge].b];
    builder.insert_segment(a.x, a.y, b.x, b.y);
  }
  builder.construct(&diagram);
}

VoronoiSite site_of(const Diagram::cell_type& cell, const LineWork& work,
                    const std::vector<std::uint32_t>& edges) {
  const std::uint32_t number = edges[cell.source_index()];
  const GridPoint a = work.vertices[work.edges[number].a], b = work.vertices[work.edges[number].b];
  if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT) {
    return {a, a, number};
  }
  if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT) {
    return {b, b, number};
  }
  return {a, b, number};
}

void add_edges(const Diagram& diagram, VoronoiGraph& graph) {
  const auto& edges = diagram.edges();
  for (std::size_t i = 0; i < edges.size(); i += 2) {  // twins follow each other
    const auto& edge = edges[i];
    if (!edge.is_primary() || !edge.is_finite()) continue;
    const auto number = [&](const Diagram::vertex_type* vertex) {
      return static_cast<std::uint32_t>(vertex - diagram.vertices().data());
    };
    const auto site = [&](const Diagram::edge_type& side) {
      return static_cast<std::uint32_t>(side.cell() - diagram.cells().data());
    };
    graph.edges.push_back(
        {number(edge.vertex0()), number(edge.vertex1()), site(edge), site(*edge.twin())});
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

VoronoiGraph build_voronoi_graph(const Tessellation& space) {
  VoronoiGraph graph;
  const auto edges = bounding_edges(space);
  if (edges.empty()) {
    graph.first_edge.push_back(0);
    return graph;
  }
  Diagram diagram;
  sweep(space.work, edges, diagram);
  graph.vertices.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) graph.vertices.push_back({vertex.x(), vertex.y()});
  graph.sites.reserve(diagram.num_cells());
  for (const auto& cell : diagram.cells()) graph.sites.push_back(site_of(cell, space.work, edges));
  add_edges(diagram, graph);
  group_edges_by_site(graph);
  return graph;
}

}  // namespace mapwright::navcore::exact
