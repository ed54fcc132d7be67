// Private to this folder: what the segments in front of lasers become.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "navcore/engine/aligned.hpp"

namespace mapwright::navcore::engine {

/// A block of spans on their way into buffers of inverse ranges: 1/r = cosine · cos φ + sine · sin
/// φ for some rays.
struct alignas(kLine) SpanBlock {
  float cosine[kBlock];
  float sine[kBlock];
  std::int32_t ray[kBlock];    ///< where the vector of rays begins that the first ray is in
  std::int32_t which[kBlock];  ///< the first ray, or (AVX-512) bit i: ray + i belongs to the span
  std::int32_t end[kBlock];    ///< one beyond the last ray
  std::int32_t at[kBlock];     ///< place of `ray` in the buffers
};

/// Numbers of lanes of some blocks.
struct LaneList {
  AlignedInts lanes;
  std::size_t size = 0;
};

/// Spans in whole vectors. Which of the lanes have rays is listed apart, and so are those that have
/// many: what the inner loops do is then no question of the single span.
class SpanList {
 public:
  void clear() { lanes = seen.size = longer.size = longest.size = 0; }

  /// Makes room for so many more lanes, in vectors.
  void make_room(std::size_t more) {
    const std::size_t needed = lanes + more + 2 * kBlock;
    if (needed <= blocks.size() * kBlock) return;
    blocks.resize(2 * needed / kBlock);
    for (LaneList* list : {&seen, &longer, &longest}) list->lanes.resize(2 * needed);
  }

  std::vector<SpanBlock, LineAllocator<SpanBlock>> blocks;
  std::size_t lanes = 0;  ///< of whole vectors
  LaneList seen;          ///< those that have rays, as span_lane() numbers them
  LaneList longer;        ///< those with rays beyond the first few vectors
  LaneList longest;       ///< those with more than are done at once
};

/// Floats from the first block's `cosine` to that of the lane.
constexpr std::size_t span_lane(std::size_t lane) {
  return lane / kBlock * (sizeof(SpanBlock) / sizeof(float)) + lane % kBlock;
}

}  // namespace mapwright::navcore::engine
