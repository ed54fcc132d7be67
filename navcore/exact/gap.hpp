// Private to this folder: The gap between two sites.
#pragma once

#include <optional>

#include "navcore/exact/voronoi_graph.hpp"

namespace mapwright::navcore::exact {

/// The nearest points of two sites, if a disc between them is held by these two alone.
struct Gap {
  Point from, to;  ///< mm; on the first and on the second site
  double width_mm = 0.0;

  Point middle() const { return 0.5 * (from + to); }
};

/// Gap between two points, a point and a segment (from the point's foot, which must fall into the
/// segment), or two parallel segments that face each other. Nothing for sites that touch and for
/// segments that are not parallel: a passage between those is narrowest at one of their ends. The
/// width is the exact value, rounded once for its square and once for the root.
std::optional<Gap> gap_between(const VoronoiSite& p, const VoronoiSite& q);

/// Foot of the perpendicular from p (mm) to the line through a segment.
Point foot_on_line(Point p, const VoronoiSite& segment);

}  // namespace mapwright::navcore::exact
