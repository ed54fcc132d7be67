// One look at every obstacle, which spares most of them the checks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapcore/map.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {

/// Why a check must look at an obstacle: it is not proven that checks of this kind are silent.
enum class Doubt : std::uint8_t {
  kEmpty,          ///< it has no segments
  kNegativeId,     ///<
  kCoordinates,    ///< some may be beyond `max_coordinate_m`
  kZeroLength,     ///< a segment has no length
  kChain,          ///< no sound chain: see ChainProof; a sound closed one is a simple
                   ///< counter-clockwise ring, no sliver and no inner ring
  kSpike,          ///< a corner may be a spike
  kEndNearItself,  ///< an open chain's end may come near another segment of it
  kHeights,        ///< some may be below 0 or above `max_height_m`
  kLow,            ///< no stairs or ramp, and not higher than the laser
  kHigh,           ///< no stairs or ramp, and maybe higher than `suspect_height_m`
  kMixedInOut,     ///< indoor and outdoor segments
  kWords,          ///< a semantic string may not be sound: see Words
  kInnerRing,      ///< the semantic string has a token inner_of
  kStairs,         ///< stairs, but no plain flight
  kRamp,           ///< a ramp, but no plain one
};
inline constexpr std::size_t kDoubts = 15;

/// Positions of obstacles, ascending.
using Positions = std::vector<std::uint32_t>;

/// Looks at each obstacle once, and proves what it can about it (docs/decisions/0095).
class Survey {
 public:
  /// With `Proofs::kNone` every obstacle is in every doubt, as if nothing could be proven: what
  /// checks say does not depend on it.
  Survey(const Map& map, const ValidationOptions& options, Proofs proofs);

  /// The obstacles in that doubt; others no check of the kind needs to look at.
  const Positions& in_doubt(Doubt doubt) const {
    return in_doubt_[static_cast<std::size_t>(doubt)];
  }

  const std::vector<Box>& boxes() const { return boxes_; }  ///< empty where there are no segments
  const Box& extent() const { return extent_; }             ///< of all of them
  const Positions& open_chains() const { return open_chains_; }  ///< with segments

  /// False only if no two obstacles have the same id.
  bool ids_may_repeat() const { return ids_may_repeat_; }
  /// False only if no two obstacles, but parts of one, have the same name on the same level.
  bool names_may_repeat() const { return names_may_repeat_; }

 private:
  friend class Surveyor;
  Survey() = default;
  void doubt_everything(const Map& map);

  std::array<Positions, kDoubts> in_doubt_;
  std::vector<Box> boxes_;
  Positions open_chains_;
  Box extent_ = kEmptyBox;
  bool ids_may_repeat_ = false;
  bool names_may_repeat_ = false;
};

}  // namespace mapwright::validators
