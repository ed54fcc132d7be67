// Private to this folder: memory that parent and child share, for what there is most of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace mapwright::converter {

/// Slots in memory that a process shares with the child it forks. The child fills them in turn and
/// says so over the line; the parent says when it has done with one. Half of the time that bytes
/// take through a socket is copying them in and out of the kernel.
class SharedBatches {
 public:
  static constexpr std::size_t kSlots = 8;
  static constexpr std::size_t kSlotBytes = std::size_t{1} << 17U;

  /// Null where there is no memory to share; the line does it all then.
  static std::unique_ptr<SharedBatches> create();
  SharedBatches(const SharedBatches&) = delete;
  SharedBatches& operator=(const SharedBatches&) = delete;
  ~SharedBatches();

  std::span<char> slot(std::size_t number) const {
    return {memory_ + (number % kSlots) * kSlotBytes, kSlotBytes};
  }

 private:
  explicit SharedBatches(char* memory) : memory_(memory) {}

  char* memory_;
};

/// What the child says of a slot it has filled.
struct FilledSlot {
  std::uint64_t number = 0;  ///< counted from the first one of a layer
  std::uint64_t bytes = 0;
};

}  // namespace mapwright::converter
