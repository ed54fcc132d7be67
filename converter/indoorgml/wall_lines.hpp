// Private to this folder: walls between cells, each once, with gaps where one can pass.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "mapcore/geometry/segment_index.hpp"
#include "mapcore/point.hpp"

namespace mapwright::converter {

/// An edge of a floor, or of a boundary: the cell lies on its right.
struct WallEdge {
  Point a, b;
  std::size_t owner = 0;  ///< cells come before boundaries
};

/// For `SegmentIndex`, which wants segments.
SegmentIndex index_of(const std::vector<WallEdge>& edges);

struct WallRules {
  double tolerance = 0.0;  ///< lines nearer than this are one, in the unit of the coordinates
  std::vector<std::pair<Point, Point>> openings;
  /// True where nothing stands between two cells.
  std::function<bool(std::size_t, std::size_t)> are_open;
};

/// Walls of all owners: an edge, but where an opening lies on it, where an owner before it has the
/// wall already, and where its own floor goes on beyond it.
class WallLines {
 public:
  WallLines(std::vector<WallEdge> edges, WallRules rules);

  /// Lines of one owner's walls, its edges in their order; those that follow each other are one.
  std::vector<std::vector<Point>> of(std::size_t owner) const;

 private:
  using Span = std::pair<double, double>;  // from and to, as shares of an edge

  void append_walls(std::size_t edge, std::vector<std::vector<Point>>& lines) const;
  std::vector<Span> taken_spans(std::size_t edge) const;
  bool takes(std::size_t edge, std::size_t other) const;

  std::vector<WallEdge> edges_;
  WallRules rules_;
  SegmentIndex edge_index_, opening_index_;
};

}  // namespace mapwright::converter
