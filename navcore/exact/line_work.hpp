// Line work: segments on the millimetre grid that meet nowhere but at shared ends.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "navcore/exact/grid_point.hpp"

namespace mapwright::navcore::exact {

/// A directed segment and what it stands for.
struct Line {
  GridPoint a, b;
  std::uint32_t source = 0;  ///< the caller's: which input it came from
};

/// A line, or a part of one, along an edge.
struct Piece {
  std::uint32_t source = 0;
  bool reversed = false;  ///< the line runs against the edge
};

/// An edge between two vertices, a < b as vertex numbers.
struct Edge {
  std::uint32_t a = 0, b = 0;
  std::uint32_t first_piece = 0, last_piece = 0;  ///< [first, last) of LineWork::pieces
};

/// Lines that have been cut where they meet: two edges share an end or nothing.
struct LineWork {
  std::vector<GridPoint> vertices;  ///< each once, near ones mostly near in memory
  std::vector<Edge> edges;          ///< ascending by (a, b), each once
  std::vector<Piece> pieces;        ///< grouped by edge; within an edge ascending by source

  /// Greatest distance that a point of a line may have been moved (mm): 0 where every meeting was
  /// at a grid point.
  double displacement_mm = 0.0;
  std::optional<GridPoint> displaced_at;  ///< the first of the others; nothing where all were
};

/// Cuts lines where they cross, touch or overlap. Lines of no length are dropped.
///
/// Lines that meet only at points of the grid keep their exact place. Otherwise every line is
/// routed through the centres of the grid squares it crosses in which some line ends or two lines
/// cross (snap rounding: Hobby, Practical segment intersection with finite precision output, 1999),
/// which moves no point of a line by more than half a square's diagonal. Deterministic.
LineWork node(const std::vector<Line>& lines);

}  // namespace mapwright::navcore::exact
