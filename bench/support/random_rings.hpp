// Random rings, most of them degenerate.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mapcore/point.hpp"
#include "mapcore/random.hpp"

namespace mapwright::bench {

/// What is special about a ring.
enum class RingKind : std::uint8_t {
  kSmallGrid,       ///< vertices anywhere on a grid of 3 × 3 to 6 × 6 points
  kCollinear,       ///< vertices on two lines
  kRepeated,        ///< a simple ring with vertices that stand twice, in a row or apart
  kTouching,        ///< a simple ring one vertex of which lies on another edge
  kSpiked,          ///< a simple ring from which a spike runs out and exactly back
  kAlmostTouching,  ///< the touching one, moved by a few units in the last place
  kManyVertices,    ///< up to 80 vertices, so that the sweep decides
  kFarAway,         ///< millimetres in UTM coordinates, two vertices perhaps exchanged
};
inline constexpr std::uint64_t kRingKinds = 8;

std::string_view to_string(RingKind kind);

/// A ring of three vertices or more; the first is not repeated at the end.
std::vector<Point> random_ring(RingKind kind, Random& random);

}  // namespace mapwright::bench
