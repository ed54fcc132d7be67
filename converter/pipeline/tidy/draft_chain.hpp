// Drafts as chains of points that share one style.
#pragma once

#include <optional>
#include <vector>

#include "converter/pipeline/draft.hpp"

namespace mapwright::converter {

/// A draft's points, and what all of its segments have in common.
struct DraftChain {
  std::vector<Point> points;  ///< of a ring without the first one repeated
  bool closed = false;
  SegmentStyle style;
};

/// Nothing for stairs and ramps, whose points mean more than their place, and for chains whose
/// segments differ in height, side or labels.
std::optional<DraftChain> chain_of_draft(const Draft& draft);

/// True if the chain is what the map may hold: a simple ring of an area, or a simple chain.
bool is_sound(const DraftChain& chain);

/// Puts the chain's points in place of the draft's.
void set_chain(const DraftChain& chain, Draft& draft);

}  // namespace mapwright::converter
