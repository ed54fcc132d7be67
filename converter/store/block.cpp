#include "converter/store/block.hpp"

#include <sys/mman.h>

#include <cstdint>

namespace mapwright::converter {
namespace {

constexpr std::uintptr_t kPage = 4096;

// The whole pages within. A system that cannot do it leaves them to page faults.
void populate(void* block, std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
  const auto at = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t from = (at + kPage - 1) / kPage * kPage;
  const std::uintptr_t to = (at + bytes) / kPage * kPage;
  if (from < to) ::madvise(reinterpret_cast<void*>(from), to - from, MADV_POPULATE_WRITE);
#else
  static_cast<void>(block);
  static_cast<void>(bytes);
#endif
}

}  // namespace

Block make_block(std::size_t bytes) {
  Block block(::operator new(bytes));
  if (bytes >= kLargestBlock) populate(block.get(), bytes);
  return block;
}

}  // namespace mapwright::converter
