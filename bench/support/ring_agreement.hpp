// Whether "is this ring valid?" has one answer: ours, GEOS's, and CGAL's in exact arithmetic.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bench/support/random_rings.hpp"

namespace mapwright::bench {

/// What is_simple_ring, GEOS and CGAL's exact kernel say of a ring.
enum class RingOutcome : std::uint8_t {
  kAllValid,
  kAllInvalid,
  /// Only GEOS calls it valid, since it takes a vertex that stands twice in a row as one; without
  /// the repetition all agree. Here it is a segment without length (G103).
  kRepeatsInARow,
  /// GEOS works in double-double arithmetic (106 bits): it takes three vertices for being on one
  /// line that are not, in some order of asking.
  kBelowDoubleDouble,
  kUnexplainedGeos,
  kUnexplainedCgal,
};
inline constexpr std::size_t kRingOutcomes = 6;

std::string_view to_string(RingOutcome outcome);

struct RingAgreement {
  std::array<std::array<std::uint64_t, kRingOutcomes>, kRingKinds> counts{};
  std::uint64_t unexplained = 0;
  std::vector<std::string> examples;  ///< the first unexplained ones, as WKT
};

/// Asks all three about `rings` random rings of all kinds in turn. Ring i of a seed is always the
/// same one.
RingAgreement compare_rings(std::uint64_t rings, std::uint64_t seed);

}  // namespace mapwright::bench
