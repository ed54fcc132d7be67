// Memory for many small arrays that live and die together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

#include "converter/store/block.hpp"

namespace mapwright::converter {

/// Hands out arrays of plain values from large blocks; they stay where they are until the arena
/// goes.
template <class T, std::size_t kMostBytes = kLargestBlock>
class Arena {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Room for `count` values, not set.
  T* take(std::size_t count) {
    if (count > left_) grow(count);
    T* const at = next_;
    next_ += count;
    left_ -= count;
    return at;
  }

  /// Gives back the end of what was taken last.
  void give_back(std::size_t count) {
    next_ -= count;
    left_ += count;
  }

 private:
  void grow(std::size_t count) {
    const std::size_t bytes = std::max(count * sizeof(T), block_bytes_);
    blocks_.push_back(make_block(bytes));
    next_ = static_cast<T*>(blocks_.back().get());
    left_ = bytes / sizeof(T);
    block_bytes_ = std::min(2 * block_bytes_, kMostBytes);
  }

  std::vector<Block> blocks_;
  T* next_ = nullptr;
  std::size_t left_ = 0;
  std::size_t block_bytes_ = kLeastBlock;
};

}  // namespace mapwright::converter
