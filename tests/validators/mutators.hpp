// Ways to break a clean map, one a finding.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/map.hpp"
#include "mapcore/random.hpp"

namespace mapwright::test {

/// What must be found in a broken map.
struct Expected {
  std::optional<std::size_t> obstacle;  ///< position of the obstacle to blame; none: the border
  std::vector<std::size_t> segments;    ///< any of these, 1-based; empty: none named
};

struct Mutator {
  FindingCode code;
  /// Breaks the map at a random place; nothing where it has no place to break this way.
  std::optional<Expected> (*mutate)(Map&, Random&);
};

/// One for each finding of the families G, S and T.
const std::vector<Mutator>& mutators();

/// The parts of `mutators`: slips that break a map, and finer ones of shapes, of attributes, and of
/// stairs and ramps.
const std::vector<Mutator>& coarse_mutators();
const std::vector<Mutator>& shape_mutators();
const std::vector<Mutator>& attribute_mutators();
const std::vector<Mutator>& stairs_mutators();

/// A map without defects that has something of everything: a generated campus and beside it a
/// building with courtyard, a room with furniture, walls that lean on outlines, stairs in both
/// orders, a ramp.
Map clean_map(std::uint64_t seed);

}  // namespace mapwright::test
