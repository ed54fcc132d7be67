// Shares equal semantic strings while a map is read.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "mapcore/semantic.hpp"

namespace mapwright::text {

/// Gives equal strings one text, as far as it remembers: the last string of each of 256 hashes.
class SemanticCache {
 public:
  const Semantic& get(std::string_view text) {
    if (text.empty()) return empty_;
    Semantic& entry = entries_[slot(text)];
    if (entry.view() != text) entry = Semantic(text);
    return entry;
  }

 private:
  static constexpr std::size_t kEntryBits = 8;

  // Hashes length, beginning and end: where strings of one map differ.
  static std::size_t slot(std::string_view text) {
    std::uint64_t head = 0;
    std::uint64_t tail = 0;
    const std::size_t size = std::min(text.size(), sizeof head);
    std::memcpy(&head, text.data(), size);
    std::memcpy(&tail, text.data() + text.size() - size, size);
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
    const std::uint64_t hash = (head ^ std::rotl(tail, 23) ^ text.size()) * kGolden;
    return hash >> (64U - kEntryBits);
  }

  Semantic empty_;
  std::array<Semantic, std::size_t{1} << kEntryBits> entries_;
};

}  // namespace mapwright::text
