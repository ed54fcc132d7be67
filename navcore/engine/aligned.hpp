// Private to this folder: arrays that vector instructions load without crossing cache lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace mapwright::navcore::engine {

/// Length of a cache line and of the longest vector, bytes.
inline constexpr std::size_t kLine = 64;

/// Floats in a block: as many as the longest vector holds. Arrays for the kernels are padded to
/// whole blocks.
inline constexpr std::size_t kBlock = kLine / sizeof(float);

constexpr std::size_t padded_to_block(std::size_t n) {
  return (n + kBlock - 1) / kBlock * kBlock;
}

template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  explicit LineAllocator(const LineAllocator<U>&) {}

  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{kLine}));
  }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{kLine}); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

using AlignedFloats = std::vector<float, LineAllocator<float>>;
using AlignedInts = std::vector<std::int32_t, LineAllocator<std::int32_t>>;

}  // namespace mapwright::navcore::engine
