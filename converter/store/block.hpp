// Blocks of memory that the stores of this folder are made of.
#pragma once

#include <cstddef>
#include <memory>

namespace mapwright::converter {

inline constexpr std::size_t kLeastBlock = std::size_t{1} << 12U;

/// Small enough to come from the heap, which keeps the pages when the block goes: what is asked for
/// next need not touch new ones, and that costs more than filling them.
inline constexpr std::size_t kLargestBlock = std::size_t{1} << 16U;

/// For what outlives the rest, and beside the heap: between blocks that go, one that stays would
/// keep their memory from becoming one piece again.
inline constexpr std::size_t kLastingBlock = std::size_t{1} << 20U;

struct ReleaseBlock {
  void operator()(void* block) const;
  std::size_t mapped_bytes = 0;  ///< 0: from the heap
};
using Block = std::unique_ptr<void, ReleaseBlock>;

/// Memory that is not set; from the system itself where it is a lasting block. All of a large block
/// will be used, so the system is asked for its pages at once: that takes two thirds of the time of
/// a page fault for each.
Block make_block(std::size_t bytes);

}  // namespace mapwright::converter
