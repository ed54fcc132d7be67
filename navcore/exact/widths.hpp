// Private to this folder: How wide the ways through a free space are.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
#include "navcore/exact/medial_rounds.hpp"
#include "navcore/exact/voronoi_graph.hpp"

namespace mapwright::navcore::exact {

/// The narrowest place of a way (mm, grid).
struct NarrowPlace {
  double width_mm = 0.0;  ///< diameter of the largest disc that passes
  Point at;               ///< where the disc's centre is then
  Point from, to;         ///< the nearest points of the two edges that make the gap
  std::uint32_t edge_from = 0, edge_to = 0;  ///< those edges, of the line work
  /// The way is nowhere narrower than at one of its ends: `from` is what is nearest to that end,
  /// and `to` equals it.
  bool is_end = false;
};

/// For any two places, the largest disc that can travel from one to the other.
///
/// Discs travel best along the medial axis, so a maximum spanning forest of it answers for all
/// pairs and all radii. A passage is narrowest where its two sides are nearest to each other: its
/// width is then the distance of two points, or of a point and a line, of the integer input, and is
/// computed from those (one rounding of the exact quotient) instead of from Voronoi vertices.
/// Immutable once built.
class Widths {
 public:
  explicit Widths(const Tessellation& space);

  /// Narrowest place of the widest way between two free points. Nothing where no disc travels, not
  /// even a small one.
  std::optional<NarrowPlace> widest_way(GridPoint a, GridPoint b) const;

  /// A way between two free points on which a disc as wide as `widest_way` says can travel (mm,
  /// corners, both ends included): straight to the medial axis, along it, and straight to the other
  /// point. Where the axis is curved, tangents stand for it that come nowhere nearer to a wall than
  /// the curve. Exact but for the rounding of Voronoi vertices (64 units in the last place). Empty
  /// where no disc travels.
  std::vector<Point> widest_route(GridPoint a, GridPoint b) const;

  /// What bounds the ground on which a disc of this diameter (mm) that stands at p can travel:
  /// rounds of sites too near to each other for it to pass between. `space` as for the constructor.
  /// Empty for a point on an edge.
  std::vector<SiteRound> rounds_around(const Tessellation& space, GridPoint p,
                                       double diameter_mm) const;

  /// True if a disc of this diameter passes; touching is passing.
  static bool is_wide_enough(double width_mm, double diameter_mm);

  /// A number that two free points share if and only if a disc of this diameter (mm) can travel
  /// from one to the other. Requires that it can stand at the point; nothing for a point on an
  /// edge.
  std::optional<std::size_t> region_of(GridPoint p, double width_mm) const;

 private:
  // Where an edge of the medial axis is narrowest.
  struct Passage {
    double width_mm = 0.0;
    Point at;
  };
  // Union by size without path compression: a node remembers through which edge it was joined to
  // its parent, and joins grow narrower towards the root.
  struct Link {
    std::uint32_t parent;
    std::uint32_t rank;  // position of the edge in the order of joining
  };
  // From a place along its clearance's ascent to an edge of the medial axis, and on to its ends.
  struct Foot {
    std::uint32_t edge = 0;
    Point at;
    double clearance_mm = 0.0;  // of the place itself
    std::uint32_t nearest_site = 0;
  };
  struct Way {
    std::uint32_t edge = 0;
    Passage narrowest{-1.0, {}};
    double ends_mm = -1.0;  // width on the first and the last edge of the medial axis
    // Of the medial axis; none where both ends lie on one edge and the way does not leave it.
    std::uint32_t first_vertex = UINT32_MAX, last_vertex = UINT32_MAX;
  };

  // A segment of index_, and the sites of its inside and its ends.
  struct IndexedSites {
    std::uint32_t inside, a, b;
  };

  Passage measure(const VoronoiEdge& edge, Point p, Point q) const;
  double clearance_at(const VoronoiEdge& edge, Point p) const;
  void order_edges();
  void grow_forest();
  void index_sites(const LineWork& work);
  std::optional<std::uint32_t> narrowest_between(std::uint32_t a, std::uint32_t b) const;
  std::optional<Foot> foot_of(GridPoint p) const;
  std::optional<Foot> follow_ray(std::uint32_t site, Point from, Point direction,
                                 double clearance_mm) const;
  double distance_off(const VoronoiEdge& edge, Point p) const;
  Way between(const Foot& a, const Foot& b) const;
  void follow_edge(const VoronoiEdge& edge, Point p, Point q, std::vector<Point>& points) const;
  std::uint32_t top_before(std::uint32_t v, std::uint32_t rank) const;
  void follow_forest(std::uint32_t from, std::uint32_t to, std::vector<Point>& points) const;
  NarrowPlace place_on(const Way& way) const;
  NarrowPlace place_at_end(GridPoint p, const Foot& foot) const;

  VoronoiGraph graph_;
  std::vector<Passage> passages_;     // by edge
  std::vector<std::uint32_t> order_;  // edges, widest first
  std::vector<Link> links_;           // by vertex
  std::optional<SegmentIndex> index_;
  std::vector<IndexedSites> indexed_sites_;  // by position in index_
};

}  // namespace mapwright::navcore::exact
