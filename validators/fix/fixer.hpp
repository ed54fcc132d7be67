// What a fixer sees, and what it proposes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mapcore/finding.hpp"
#include "mapcore/text/document.hpp"
#include "validators/fix/record_text.hpp"

namespace mapwright::validators {

/// A map and what is wrong with it.
struct FixContext {
  const MapDocument& document;
  const std::vector<Finding>& findings;
  double snap_m;
};

/// A repair that a fixer proposes. Its edits are in order and do not overlap.
struct Proposal {
  std::optional<FindingCode> code;      ///< absent for the layout
  std::optional<std::size_t> obstacle;  ///< position of the obstacle it is about
  std::string message;  ///< what is done: "obstacle 26: its last end joined to its first"
  std::vector<OffsetEdit> edits;
  double moved_m = 0.0;  ///< the farthest that an end of a segment, or a side of the border, moves
};

using Proposals = std::vector<Proposal>;

/// Every fixer is a function of this kind, `fix_<name>` in fixes/<name>.cpp, and a line in
/// fixes.def.
using Fixer = Proposals(const FixContext&);

#define MAPWRIGHT_FIX(name, codes, summary) Fixer fix_##name;
#include "validators/fix/fixes.def"
#undef MAPWRIGHT_FIX

/// Position of the obstacle that a finding blames; nothing where it blames none.
std::optional<std::size_t> blamed_position(const FixContext& context, const Finding& finding);

/// Position of the obstacle that each finding of `code` blames, each position once, ascending.
std::vector<std::size_t> blamed(const FixContext& context, FindingCode code);

/// The segments (0-based) that findings of `code` blame in the obstacle at `position`, ascending.
std::vector<std::size_t> blamed_segments(const FixContext& context, FindingCode code,
                                         std::size_t position);

/// True if a finding of that code is there.
bool is_found(const FixContext& context, FindingCode code);

}  // namespace mapwright::validators
