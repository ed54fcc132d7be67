// Counting bytes of a text; plain loops over bytes that a compiler turns into vector instructions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "mapcore/text/characters.hpp"

namespace mapwright::text {

/// How many bytes `is_one` (unsigned char → bool) holds for.
template <class Predicate>
std::size_t count_bytes(std::string_view text, Predicate is_one) {
  // Sums of at most 255 ones fit a byte, and bytes are what vectors hold most of.
  constexpr std::size_t kChunk = 240;
  std::size_t total = 0;
  for (std::size_t at = 0; at < text.size(); at += kChunk) {
    const char* const begin = text.data() + at;
    const std::size_t size = std::min(kChunk, text.size() - at);
    std::uint8_t count = 0;
    for (std::size_t i = 0; i < size; ++i) {
      count = static_cast<std::uint8_t>(count + is_one(static_cast<unsigned char>(begin[i])));
    }
    total += count;
  }
  return total;
}

/// True if all bytes are ASCII.
inline bool is_ascii(std::string_view text) {
  constexpr std::size_t kChunk = 1024;
  for (std::size_t at = 0; at < text.size(); at += kChunk) {
    const std::size_t end = std::min(at + kChunk, text.size());
    unsigned char all = 0;
    for (std::size_t i = at; i < end; ++i) all |= static_cast<unsigned char>(text[i]);
    if (all >= 0x80) return false;
  }
  return true;
}

/// False where a byte is beyond ' ' to '~', eight bytes at a time: for short texts.
inline bool is_printable_ascii(std::string_view text) {
  constexpr std::uint64_t kOnes = 0x0101010101010101U;
  std::uint64_t odd = 0;
  // The highest bit of a byte is set in it, or by taking ' ' from less, or by adding 1 to DEL.
  const auto look_at = [&](const char* eight) {
    std::uint64_t word = 0;
    std::memcpy(&word, eight, sizeof word);
    odd |= word | (word - kOnes * ' ') | (word + kOnes);
  };
  constexpr std::size_t kEight = sizeof odd;
  if (text.size() < kEight) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  }
  for (std::size_t at = 0; at + kEight <= text.size(); at += kEight) look_at(text.data() + at);
  look_at(text.data() + text.size() - kEight);
  return (odd & (kOnes << 7U)) == 0;
}

/// Code points: all bytes but those that continue a UTF-8 sequence.
inline std::size_t count_characters(std::string_view text) {
  return count_bytes(text, [](unsigned char byte) { return (byte & 0xC0U) != 0x80U; });
}

inline std::size_t count_byte(std::string_view text, char wanted) {
  return count_bytes(
      text, [wanted](unsigned char byte) { return byte == static_cast<unsigned char>(wanted); });
}

/// Bytes for which `is_control` holds.
inline std::size_t count_controls(std::string_view text) {
  return count_bytes(text, [](unsigned char byte) {
    const auto above_tab = static_cast<unsigned char>(byte - '\t');
    return static_cast<bool>(((byte < ' ') & (above_tab > '\r' - '\t')) | (byte == 0x7F));
  });
}

}  // namespace mapwright::text
