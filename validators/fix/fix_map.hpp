// Safe repairs of a map's text.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/tolerances.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// The findings that something in fixes.def repairs, where it can be done safely; ascending.
const std::vector<FindingCode>& fixable_codes();

struct FixOptions {
  ValidationOptions validation;
  /// Ends nearer to each other than this were meant to be one point. No end moves farther.
  double snap_m = tolerance::kSnap_m;
  std::set<FindingCode> codes{fixable_codes().begin(), fixable_codes().end()};  ///< to repair
  bool layout = true;  ///< bring records into the canonical layout, numbers kept to the bit
};

/// One repair: what was done, or what was undone again.
struct Repair {
  std::optional<FindingCode> code;       ///< absent for the layout
  std::optional<std::int64_t> obstacle;  ///< id
  std::string message;
  double moved_m = 0.0;  ///< the farthest that an end of a segment, or a side of the border, moved
  std::vector<Finding> brought = {};  ///< of an undone repair: the new findings

  friend bool operator==(const Repair&, const Repair&) = default;
};

/// How far the ends of an obstacle's segments moved.
struct Movement {
  std::int64_t obstacle = 0;  ///< id
  double moved_m = 0.0;       ///< greater than 0
};

struct FixOutcome {
  std::string text;             ///< the repaired map
  std::vector<Repair> done;     ///< in the order they were done
  std::vector<Repair> undone;   ///< not in `text`, because they would bring new findings
  std::vector<Movement> moved;  ///< obstacles whose ends moved, by id
  double border_moved_m = 0.0;
  std::vector<Finding> before, after;  ///< what validation finds
};

/// Repairs what can be repaired safely, by edits of the text: bytes that no repair is about stay,
/// and so do the order of obstacles, tokens nobody knows and text that belongs to no record.
///
/// After all repairs the map is validated. If there is a finding that was not there before (one of
/// that code about that obstacle, or more of them), the last repair that can have brought it is
/// left out, and all begins anew. Repairing the result again changes nothing.
FixOutcome fix_map(std::string text, const FixOptions& options = {});

}  // namespace mapwright::validators
