// Characters of the map text: white space, letters, UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mapwright::text {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// White space that carries no meaning around a field: blank, tab, LF, VT, FF, CR.
constexpr bool is_blank(char c) {
  constexpr std::uint64_t kBlanks = (std::uint64_t{1} << ' ') | (std::uint64_t{0x1F} << '\t');
  const auto byte = static_cast<unsigned char>(c);
  return byte <= ' ' && ((kBlanks >> byte) & 1U) != 0;
}

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A byte no text has: below the blank and no white space, or DEL.
constexpr bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < ' ' && !is_blank(c)) || byte == 0x7F;
}

/// `text` without white space at its ends. An empty answer points to the end of `text`.
std::string_view trimmed(std::string_view text);

/// Bytes of the UTF-8 sequence `text` begins with; 0 where it begins with none (overlong forms,
/// surrogates and values beyond U+10FFFF are none).
std::size_t utf8_sequence_length(std::string_view text);

/// Offset of the first byte that is not UTF-8; npos where all is well.
std::size_t find_invalid_utf8(std::string_view text);

/// The text for a message: in single quotes, control characters and bytes that are not UTF-8
/// escaped, cut after 40 characters.
std::string quoted(std::string_view text);

}  // namespace mapwright::text
