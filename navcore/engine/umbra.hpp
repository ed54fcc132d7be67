// Private to this folder: what a segment hides from every point of a cell.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "navcore/engine/planar.hpp"

namespace mapwright::navcore::engine {

/// The region behind a segment that no point of a square can see past it.
///
/// From one viewpoint v a point q is hidden by the segment ab when vq meets ab; for fixed q the
/// viewpoints from which that holds form a convex cone, so what is hidden from the corners of the
/// square is hidden from all of it. The region is an intersection of three half-planes: beyond the
/// line ab and between the innermost lines of sight past a and past b.
class Umbra {
 public:
  /// Nothing where the line through a and b does not keep clear of the square.
  static std::optional<Umbra> of(Point a, Point b, const Square& square);

  /// True if the closed segment pq is hidden as a whole. A segment on the line ab is not.
  bool hides(Point p, Point q) const {
    return holds(p) && holds(q) && (is_beyond(p) || is_beyond(q));
  }

  /// Sine of the angle under which the square's centre sees the segment: the larger, the more it
  /// is likely to hide.
  double apparent_size() const { return apparent_size_; }

 private:
  bool holds(Point q) const {
    return cross(past_a_, q - a_) >= 0.0 && cross(q - b_, past_b_) >= 0.0 &&
           side_of_line(a_, b_, q) <= 0.0;
  }
  bool is_beyond(Point q) const { return side_of_line(a_, b_, q) < -clear_; }

  Point a_, b_;            ///< the square lies on the left of a→b
  Point past_a_, past_b_;  ///< directions of the innermost lines of sight
  double clear_ = 0.0;
  double apparent_size_ = 0.0;
};

/// Segments that hide as much as the chain of walls given by its vertices, or nearly so: for parts
/// of it that bulge towards the square, the chord between their ends. Appends to `umbras`.
///
/// Why a chord may stand for its walls: with them it bounds a region that lies on the square's side
/// of the chord, while the square is outside of the region. A line of sight from the square to a
/// point beyond the chord crosses the region's boundary an even number of times, the chord once,
/// hence a wall. Chains must be connected; they need not be simple.
void add_chord_umbras(std::span<const Point> chain, const Square& square,
                      std::vector<Umbra>& umbras);

}  // namespace mapwright::navcore::engine
