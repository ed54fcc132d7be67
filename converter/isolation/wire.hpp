// Private to this folder: values as bytes, on their way between two processes of one program.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// Appends values to a buffer, in the machine's own representation.
class WireWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { append(&value, sizeof value); }
  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size()));
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    if constexpr (std::is_trivially_copyable_v<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const auto& value : values) put(value);
    }
  }

  const std::vector<char>& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  void append(const void* data, std::size_t size) {
    if (size == 0) return;
    const auto* begin = static_cast<const char*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<char> bytes_;
};

/// Takes values out of a buffer. What ends too early gives zeros and is not `good`.
class WireReader {
 public:
  WireReader(const char* begin, std::size_t size) : next_(begin), left_(size) {}

  bool good() const { return good_; }
  bool at_end() const { return left_ == 0; }

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(T& value) { take(&value, sizeof value); }
  void get(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
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

void put(WireWriter& wire, const SourceFeature& feature);
void get(WireReader& wire, SourceFeature& feature);

void put(WireWriter& wire, const std::vector<LayerInfo>& layers);
void get(WireReader& wire, std::vector<LayerInfo>& layers);

void put(WireWriter& wire, const ReadOptions& options);
void get(WireReader& wire, ReadOptions& options);

void put(WireWriter& wire, const Failure& failure);
void get(WireReader& wire, Failure& failure);

}  // namespace mapwright::converter
