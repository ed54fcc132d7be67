// An obstacle's segments, cut where they meet others.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/map.hpp"

namespace mapwright::validators {

/// Where a segment meets an edge of another obstacle.
struct Cut {
  double t = 0.0;  ///< along the segment: 0 at a, 1 at b
  Point at;
  std::uint32_t obstacle = 0;  ///< whose edge it is
  std::uint32_t edge = 0;
};

/// Adds the points in which `segment` and the edge meet: one, or for overlaps the two ends.
void add_cuts(const Segment& segment, const Segment& edge, std::uint32_t obstacle,
              std::uint32_t number, std::vector<Cut>& cuts);

/// A stretch of a segment that meets no edge but at its ends.
struct Piece {
  Point from, to;
  std::optional<Cut> begins_at;  ///< the edge it begins at, if any
  std::optional<Cut> ends_at;

  Point middle() const { return 0.5 * from + 0.5 * to; }
};

/// The pieces of a segment, from a to b; sorts `cuts`.
std::vector<Piece> pieces_of(const Segment& segment, std::vector<Cut>& cuts);

}  // namespace mapwright::validators
