#include "cli/support/heap.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstdlib>

namespace mapwright::cli {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21U;
constexpr int kTopPad = 64 << 20;

// Below this, pages cost nothing that anybody would notice.
constexpr std::size_t kWorthwhile = std::size_t{32} << 20U;

// What the C library can be told to keep.
constexpr std::size_t kMost = INT_MAX - kTopPad;

// A segment takes about as many bytes in memory as in the text, and an obstacle and what is derived
// from it not much more.
constexpr double kMemoryPerTextByte = 1.1;

void advise_huge_pages(void* block, std::size_t bytes) {
  const auto from = (reinterpret_cast<std::uintptr_t>(block) + kHugePage - 1) & ~(kHugePage - 1);
  const auto to = (reinterpret_cast<std::uintptr_t>(block) + bytes) & ~(kHugePage - 1);
  if (from < to) ::madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
}

}  // namespace

void keep_freed_memory() {
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
  ::mallopt(M_TOP_PAD, kTopPad);
}

// One block of that size, taken from the heap and given back untouched: the heap has grown by it,
// and what is asked for next comes out of it. Where the heap has that much already, it stays as it
// is. From then on large blocks come out of the heap too.
void expect_memory(std::size_t bytes) {
  if (bytes < kWorthwhile) return;
  bytes = std::min(bytes, kMost);
  ::mallopt(M_MMAP_MAX, 0);
  void* const block = std::malloc(bytes);
  if (block == nullptr) return;
  advise_huge_pages(block, bytes);
  std::free(block);
}

void expect_map_of(std::size_t text_bytes) {
  expect_memory(static_cast<std::size_t>(kMemoryPerTextByte * static_cast<double>(text_bytes)));
}

}  // namespace mapwright::cli
