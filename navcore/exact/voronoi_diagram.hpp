// Private to this folder: Boost.Polygon's diagram of the edges that bound a free space. For .cpp
// files only.
#pragma once

#include <boost/polygon/voronoi.hpp>
#include <cstdint>
#include <vector>

#include "navcore/exact/voronoi_graph.hpp"

namespace mapwright::navcore::exact {

/// A diagram, and what its cells belong to.
class VoronoiDiagram {
 public:
  using Diagram = boost::polygon::voronoi_diagram<double>;
  using Cell = Diagram::cell_type;
  using HalfEdge = Diagram::edge_type;
  using Vertex = Diagram::vertex_type;

  explicit VoronoiDiagram(const Tessellation& space);

  const Diagram& diagram() const { return diagram_; }
  VoronoiSite site_of(const Cell& cell) const;

  /// True for the edges that a VoronoiGraph has: not those at which a segment meets its own end,
  /// not infinite ones, and not those beside a segment on its blocked side.
  bool is_inner(const HalfEdge& edge) const {
    return edge.is_primary() && edge.is_finite() && is_beside_free_side(edge, *edge.cell()) &&
           is_beside_free_side(edge, *edge.twin()->cell());
  }

  std::uint32_t number_of(const Vertex* vertex) const {
    return static_cast<std::uint32_t>(vertex - diagram_.vertices().data());
  }
  std::uint32_t number_of(const Cell* cell) const {
    return static_cast<std::uint32_t>(cell - diagram_.cells().data());
  }
  std::uint32_t number_of(const HalfEdge* edge) const {
    return static_cast<std::uint32_t>(edge - diagram_.edges().data());
  }

 private:
  bool is_beside_free_side(const HalfEdge& edge, const Cell& cell) const;

  const LineWork& work_;
  std::vector<char> free_sides_;      // by edge of the line work: kLeft, kRight
  std::vector<std::uint32_t> edges_;  // of the line work, by number of the diagram's segment
  Diagram diagram_;
};

}  // namespace mapwright::navcore::exact
