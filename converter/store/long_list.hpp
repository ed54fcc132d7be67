// A list that grows without moving what it holds.
#pragma once

#include <cstddef>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

#include "converter/store/arena.hpp"

namespace mapwright::converter {

/// A std::deque with chunks of a thousand.
template <class T, std::size_t kMostBytes = kLargestBlock>
class LongList {
 public:
  LongList() = default;
  LongList(LongList&& other) noexcept
      : memory_(std::move(other.memory_)),
        chunks_(std::exchange(other.chunks_, {})),
        size_(std::exchange(other.size_, 0)) {}
  LongList& operator=(LongList&& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(chunks_, other.chunks_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~LongList() {
    for (std::size_t i = 0; i < size_; ++i) (*this)[i].~T();
  }

  T& push_back(T value) {
    if (size_ == chunks_.size() * kChunk) add_chunk();
    T* const at = ::new (static_cast<void*>(&(*this)[size_])) T(std::move(value));
    ++size_;
    return *at;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return chunks_[i / kChunk][i % kChunk]; }
  const T& operator[](std::size_t i) const { return chunks_[i / kChunk][i % kChunk]; }
  T& back() { return (*this)[size_ - 1]; }

  template <class List, class Value>
  class Iterator {
   public:
    Iterator(List* list, std::size_t i) : list_(list), i_(i) {}
    Value& operator*() const { return (*list_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    List* list_;
    std::size_t i_;
  };
  auto begin() { return Iterator<LongList, T>(this, 0); }
  auto end() { return Iterator<LongList, T>(this, size_); }
  auto begin() const { return Iterator<const LongList, const T>(this, 0); }
  auto end() const { return Iterator<const LongList, const T>(this, size_); }

 private:
  static constexpr std::size_t kChunk = 1024;

  struct alignas(std::max_align_t) Unit {
    std::byte bytes[alignof(std::max_align_t)];
  };
  static_assert(alignof(T) <= alignof(Unit));

  void add_chunk() {
    constexpr std::size_t kUnits = (kChunk * sizeof(T) + sizeof(Unit) - 1) / sizeof(Unit);
    chunks_.push_back(reinterpret_cast<T*>(memory_.take(kUnits)));
  }

  Arena<Unit, kMostBytes> memory_;
  std::vector<T*> chunks_;
  std::size_t size_ = 0;
};

}  // namespace mapwright::converter
