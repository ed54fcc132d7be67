#include "validators/characters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "mapcore/text/byte_counts.hpp"

namespace mapwright::validators {
namespace {

constexpr char32_t kInvalid = 0xFFFFFFFF;

// Takes the next character off the text; kInvalid for a byte that begins none.
char32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t size = lead < 0x80   ? 1
                           : lead < 0xC2 ? 0
                           : lead < 0xE0 ? 2
                           : lead < 0xF0 ? 3
                                         : 4;
  const auto is_continuation = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
  };
  if (size == 0 || size > text.size() ||
      !std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size),
                   is_continuation)) {
    text.remove_prefix(1);
    return kInvalid;
  }
  char32_t character = size == 1 ? lead : lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) character = character << 6U | (byte(i) & 0x3FU);
  text.remove_prefix(size);
  return character;
}

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool is_in(const std::array<Range, N>& ranges, char32_t character) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const Range& range) {
    return range.first <= character && character <= range.last;
  });
}

bool is_control(char32_t character) {
  static constexpr std::array<Range, 3> kControls{{{0x00, 0x08}, {0x0B, 0x1F}, {0x7F, 0x9F}}};
  return character != '\r' && is_in(kControls, character);
}

// Direction marks, zero-width characters, private use, noncharacters.
bool has_no_picture(char32_t character) {
  static constexpr std::array<Range, 7> kInvisible{{{0x200B, 0x200F},
                                                    {0x202A, 0x202E},
                                                    {0x2060, 0x206F},
                                                    {0xE000, 0xF8FF},
                                                    {0xFEFF, 0xFEFF},
                                                    {0xFFFE, 0xFFFF},
                                                    {0xF0000, 0x10FFFF}}};
  return is_in(kInvisible, character);
}

// UTF-8 bytes C2 or C3 and a continuation byte, each taken for a character of ISO 8859-1.
bool is_wrongly_decoded(char32_t first, char32_t second) {
  return (first == 0xC2 || first == 0xC3) && second >= 0x80 && second <= 0xBF;
}

// "U+200B".
std::string code_point(char32_t character) {
  static constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string digits;
  for (auto rest = static_cast<std::uint32_t>(character); rest > 0 || digits.size() < 4;
       rest /= 16) {
    digits.insert(digits.begin(), kDigits[rest % 16]);
  }
  return "U+" + digits;
}

std::optional<std::string> defect_of(char32_t before, char32_t character) {
  if (character == kInvalid) return std::nullopt;
  if (is_wrongly_decoded(before, character)) {
    return "UTF-8 that was read as ISO 8859-1; convert the source again with its true encoding";
  }
  if (is_control(character)) return "the control character " + code_point(character);
  if (character == 0xFFFD) return "U+FFFD, which stands for a letter that was lost";
  if (has_no_picture(character)) return code_point(character) + ", which shows nothing";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> unreadable_part(std::string_view text) {
  if (text::is_printable_ascii(text)) return std::nullopt;
  char32_t before = 0;
  while (!text.empty()) {
    const char32_t character = take_character(text);
    if (auto defect = defect_of(before, character)) return defect;
    before = character;
  }
  return std::nullopt;
}

}  // namespace mapwright::validators
