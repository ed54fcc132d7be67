// Shares equal semantic strings while a map is read.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mapcore/semantic.hpp"

namespace mapwright::text {

/// Gives equal strings one text, as far as it remembers: the last string of each of 256 hashes.
class SemanticCache {
 public:
  const Semantic& get(std::string_view text) {
    Semantic& entry = entries_[slot(text)];
    if (entry.view() != text) entry = Semantic(text);
    return entry;
  }

 private:
  static constexpr std::size_t kEntries = 256;

  // Fowler, Noll, Vo: FNV-1a.
  static std::size_t slot(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return (hash ^ (hash >> 16U)) % kEntries;
  }

  std::array<Semantic, kEntries> entries_;
};

}  // namespace mapwright::text
