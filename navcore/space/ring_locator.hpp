// Which rings hold a point.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright::navcore {

/// A ring's vertices; the first is not repeated.
using RingPoints = std::vector<Point>;

/// Finds the rings around a point by counting crossings (odd-even rule), exactly.
///
/// The plane is cut into horizontal rows, each with the edges that reach into it, grouped by ring:
/// a query looks at the boxes of the rings of one row and at few edges of those that may hold the
/// point. Linear memory; immutable once built, safe to query from many threads.
class RingLocator {
 public:
  explicit RingLocator(std::span<const RingPoints> rings);

  struct Holder {
    std::uint32_t ring = 0;    ///< position in the rings given
    bool on_boundary = false;  ///< p lies on the ring itself
  };
  /// The rings that hold p, boundary included, in the order they were given.
  std::vector<Holder> holders(Point p) const;

 private:
  struct Edge {
    Point a, b;
  };
  // The edges of one ring within one row.
  struct Run {
    std::uint32_t ring = 0;
    std::size_t first_edge = 0, last_edge = 0;
    double min_x = 0.0, max_x = 0.0;  // of the whole ring
  };

  void choose_rows(std::span<const RingPoints> rings);
  std::size_t row_of(double y) const;
  void add_ring(std::span<const Point> ring, std::uint32_t number,
                std::vector<std::vector<Run>>& rows,
                std::vector<std::vector<Edge>>& row_edges) const;
  void pack(std::vector<std::vector<Run>>& rows, std::vector<std::vector<Edge>>& row_edges);

  double min_y_ = 0.0, max_y_ = -1.0, row_height_ = 1.0;
  std::size_t row_count_ = 0;
  std::vector<std::size_t> first_run_;  // per row, and one more
  std::vector<Run> runs_;
  std::vector<Edge> edges_;
};

}  // namespace mapwright::navcore
