#include "converter/store/block.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <new>

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

// Null where the system has none.
Block map_block(std::size_t bytes) {
  void* const block =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return block == MAP_FAILED ? Block() : Block(block, {bytes});
}

}  // namespace

void ReleaseBlock::operator()(void* block) const {
  mapped_bytes == 0 ? ::operator delete(block) : static_cast<void>(::munmap(block, mapped_bytes));
}

Block make_block(std::size_t bytes) {
  Block block = bytes >= kLastingBlock ? map_block(bytes) : Block();
  if (!block) block = Block(::operator new(bytes));
  if (bytes >= kLargestBlock) populate(block.get(), bytes);
  return block;
}

}  // namespace mapwright::converter
