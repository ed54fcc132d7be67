// Exact answers about points, chains and rings (CGAL's filtered exact predicates).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mapcore/point.hpp"

namespace mapwright {

enum class Turn { kRight = -1, kStraight = 0, kLeft = 1 };

/// Side of p as seen from a towards b; exact for all finite doubles.
Turn turn(Point a, Point b, Point p);

enum class RingOrientation { kClockwise = -1, kDegenerate = 0, kCounterClockwise = 1 };

/// Orientation of a ring given by its vertices (the first is not repeated). Exact also where the
/// area is tiny. Requires a simple ring for the answer to mean something; kDegenerate for fewer
/// than three vertices or no area.
RingOrientation ring_orientation(std::span<const Point> ring);

/// Signed area, m²; positive for counter-clockwise. Double precision.
double signed_area_m2(std::span<const Point> ring);

/// True if the ring's edges meet nowhere but at shared ends of neighbours, and no vertex repeats.
bool is_simple_ring(std::span<const Point> ring);

enum class PointSide { kInside, kBoundary, kOutside };

/// Where p lies with respect to a ring, by the odd-even rule; exact.
PointSide side_of_ring(std::span<const Point> ring, Point p);

/// How two closed segments meet.
enum class Meeting {
  kNone,
  kCross,    ///< at one point inside of both
  kTouch,    ///< at one point that is an end of at least one
  kOverlap,  ///< along a piece longer than a point
};

struct SegmentMeeting {
  Meeting kind = Meeting::kNone;
  Point at;  ///< a point they share, off by rounding only; of overlaps the middle
};

/// Exact classification. Zero-length segments are points.
SegmentMeeting meet(Point a, Point b, Point c, Point d);

}  // namespace mapwright
