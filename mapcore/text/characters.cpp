#include "mapcore/text/characters.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace mapwright::text {
namespace {

constexpr std::size_t kQuotedCharacters = 40;

struct Utf8Form {
  std::size_t length;
  unsigned char second_min, second_max;  ///< what the second byte may be
};

// Table 3-7 of the Unicode standard: well-formed UTF-8 byte sequences.
Utf8Form utf8_form(unsigned char lead) {
  if (lead < 0x80) return {1, 0, 0};
  if (lead < 0xC2) return {0, 0, 0};
  if (lead < 0xE0) return {2, 0x80, 0xBF};
  if (lead == 0xE0) return {3, 0xA0, 0xBF};
  if (lead == 0xED) return {3, 0x80, 0x9F};
  if (lead < 0xF0) return {3, 0x80, 0xBF};
  if (lead == 0xF0) return {4, 0x90, 0xBF};
  if (lead < 0xF4) return {4, 0x80, 0xBF};
  if (lead == 0xF4) return {4, 0x80, 0x8F};
  return {0, 0, 0};
}

bool is_ascii_word(const char* at) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return (word & 0x8080808080808080U) == 0;
}

std::string escaped(unsigned char byte) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  return {'\\', 'x', kHex[byte >> 4U], kHex[byte & 0xFU]};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t utf8_sequence_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const Utf8Form form = utf8_form(byte(0));
  if (form.length == 0 || text.size() < form.length) return 0;
  if (form.length > 1 && (byte(1) < form.second_min || byte(1) > form.second_max)) return 0;
  for (std::size_t i = 2; i < form.length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  return form.length;
}

std::size_t find_invalid_utf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    if (at + 8 <= text.size() && is_ascii_word(text.data() + at)) {
      at += 8;
      continue;
    }
    const std::size_t length = utf8_sequence_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::string_view::npos;
}

std::string quoted(std::string_view text) {
  std::string shown = "'";
  std::size_t characters = 0;
  while (!text.empty() && characters++ < kQuotedCharacters) {
    const std::size_t length = is_control(text[0]) || text[0] == '\n' || text[0] == '\r' ||
                                       text[0] == '\t' || text[0] == '\v' || text[0] == '\f'
                                   ? 0
                                   : utf8_sequence_length(text);
    if (length == 0) shown += escaped(static_cast<unsigned char>(text[0]));
    shown.append(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  if (!text.empty()) shown += "…";
  return shown + "'";
}

}  // namespace mapwright::text
