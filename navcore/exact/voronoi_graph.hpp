// Private to this folder: The medial axis of the free space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/point.hpp"
#include "navcore/exact/tessellation.hpp"

namespace mapwright::navcore::exact {

/// What a Voronoi cell belongs to: the inside of an edge of the line work, or one of its ends.
struct VoronoiSite {
  GridPoint a, b;          ///< equal for an end
  std::uint32_t edge = 0;  ///< of the line work; for an end, one of those that meet there

  bool is_point() const { return a == b; }
};

/// A curve of points that have two nearest sites; straight, or a parabola between a point and a
/// segment.
struct VoronoiEdge {
  std::uint32_t from = 0, to = 0;  ///< vertices
  std::uint32_t first_site = 0, second_site = 0;
};

/// The Voronoi diagram of the edges that bound the free space, as a graph. Edges at which a segment
/// meets its own end, and edges that run off to infinity, are left out. Topology by Boost.Polygon's
/// robust sweep over the integer coordinates; the vertices' places are doubles (mm).
struct VoronoiGraph {
  std::vector<Point> vertices;
  std::vector<VoronoiEdge> edges;
  std::vector<VoronoiSite> sites;
  std::vector<std::uint32_t> first_edge;  ///< by site, and one more: range of edges_of_sites
  std::vector<std::uint32_t> edges_of_sites;

  std::span<const std::uint32_t> edges_around(std::uint32_t site) const {
    return {edges_of_sites.data() + first_edge[site], first_edge[site + 1] - first_edge[site]};
  }
};

VoronoiGraph build_voronoi_graph(const Tessellation& space);

/// Distance of p (mm) to a site.
double distance_to(const VoronoiSite& site, Point p);

}  // namespace mapwright::navcore::exact
