// What the chain of an obstacle's segments is: a ring, a chain, or broken.
#pragma once

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/map.hpp"

namespace mapwright::validators {

/// The shape of one obstacle.
struct Outline {
  Box box = kEmptyBox;
  bool is_joined = false;  ///< each segment begins where the one before it ends
  bool closes = false;     ///< the last segment ends where the first begins
  bool is_flat = false;    ///< all points lie on one line
  /// A closed shape whose chain is joined, closes and is simple: it has an inside.
  bool is_ring = false;
  RingOrientation orientation = RingOrientation::kDegenerate;  ///< of a ring
  double area_m2 = 0.0;                                        ///< of a ring, positive
  double perimeter_m = 0.0;                                    ///< of a ring

  bool is_clockwise_ring() const { return is_ring && orientation == RingOrientation::kClockwise; }
  bool is_counter_clockwise_ring() const {
    return is_ring && orientation == RingOrientation::kCounterClockwise;
  }
};

Outline outline_of(const Obstacle& obstacle);

/// Width of a long rectangle of the ring's area and perimeter, metres.
inline double mean_width_m(const Outline& ring) {
  return 2.0 * ring.area_m2 / ring.perimeter_m;
}

/// A point strictly inside of a ring (O'Rourke, Computational Geometry in C, 1.2: a convex vertex,
/// and what lies before it), moved to doubles.
Point point_inside(const Obstacle& ring);

}  // namespace mapwright::validators
