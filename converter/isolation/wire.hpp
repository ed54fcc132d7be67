// Private to this folder: values as bytes, on their way between two processes of one program.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// Appends values to a buffer, in the machine's own representation.
class WireWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) {
    std::memcpy(room(sizeof value), &value, sizeof value);
    size_ += sizeof value;
  }
  void put(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    append(text.data(), text.size());
  }
  void put(const std::string& text) { put(std::string_view(text)); }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    if constexpr (std::is_trivially_copyable_v<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const auto& value : values) put(value);
    }
  }

  /// Without its length, which the other side must know.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put_values(const std::vector<T>& values) {
    append(values.data(), values.size() * sizeof(T));
  }

  /// Where so many bytes are to be put, by somebody else.
  char* take_room(std::size_t bytes) {
    char* const at = room(bytes);
    size_ += bytes;
    return at;
  }

  std::span<const char> bytes() const { return {at_, size_}; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Goes on, empty, in memory of somebody else's, as long as that is enough.
  void write_to(std::span<char> memory) {
    at_ = memory.data();
    capacity_ = memory.size();
    size_ = 0;
  }

 private:
  // Where so many bytes may be written.
  char* room(std::size_t bytes) {
    if (bytes > capacity_ - size_) grow(bytes);
    return at_ + size_;
  }
  void grow(std::size_t bytes);
  void append(const void* data, std::size_t bytes) {
    if (bytes == 0) return;
    std::memcpy(room(bytes), data, bytes);
    size_ += bytes;
  }

  std::unique_ptr<char[]> buffer_;  // std::vector would set what is written at once
  char* at_ = nullptr;              // there, or in memory of somebody else's
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// Takes values out of a buffer. What ends too early gives zeros and is not `good`.
class WireReader {
 public:
  WireReader(const char* begin, std::size_t size) : next_(begin), left_(size) {}

  bool good() const { return good_; }
  /// Says that values do not fit together.
  void check(bool fits) { good_ = good_ && fits; }
  bool at_end() const { return left_ == 0; }

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(T& value) { take(&value, sizeof value); }
  void get(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  /// `count` values without their length.
  template <class T>
  void get_values(std::vector<T>& values, std::size_t count) {
    if (count > left_ / sizeof(T)) {
      good_ = false;
      count = 0;
    }
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  /// As many values as are to follow, each of a byte or more.
  template <class T>
  void resize(std::vector<T>& values, std::size_t count) {
    if (count > left_) good_ = false;
    values.resize(good_ ? count : 0);
  }
  template <class T>
  void get(std::vector<T>& values) {
    constexpr bool kPlain = std::is_trivially_copyable_v<T>;
    values.resize(count(kPlain ? sizeof(T) : 1));
    if constexpr (kPlain) {
      take(values.data(), values.size() * sizeof(T));
    } else {
      for (auto& value : values) get(value);
    }
  }

 private:
  // A damaged count must not make anybody allocate more than can be there.
  std::size_t count(std::size_t least_bytes) {
    std::uint32_t number = 0;
    get(number);
    if (number > left_ / least_bytes) good_ = false;
    return good_ ? number : 0;
  }
  void take(void* target, std::size_t size) {
    if (size > left_) {
      good_ = false;
      std::memset(target, 0, size);
      return;
    }
    if (size > 0) std::memcpy(target, next_, size);
    next_ += size;
    left_ -= size;
  }

  const char* next_;
  std::size_t left_;
  bool good_ = true;
};

/// Positions of the values that are sent of a layer's features: of the fields asked for, or all.
/// Both sides find them for themselves.
std::vector<std::uint32_t> sent_values(const LayerInfo& layer, const ReadOptions& options);

void put(WireWriter& wire, const SourceFeature& feature, const std::vector<std::uint32_t>& values);
/// The same bytes as for a feature that holds the row's.
void put(WireWriter& wire, const FeatureRow& row, const std::vector<std::uint32_t>& values);
/// Values that are not sent stay as they are.
void get(WireReader& wire, SourceFeature& feature, const std::vector<std::uint32_t>& values);

void put(WireWriter& wire, const std::vector<LayerInfo>& layers);
void get(WireReader& wire, std::vector<LayerInfo>& layers);

void put(WireWriter& wire, const ReadOptions& options);
void get(WireReader& wire, ReadOptions& options);

void put(WireWriter& wire, const Failure& failure);
void get(WireReader& wire, Failure& failure);

}  // namespace mapwright::converter
