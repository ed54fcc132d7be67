#include "validators/report/source_lines.hpp"

#include <algorithm>
#include <vector>

namespace mapwright::validators {
namespace {

constexpr std::size_t kLongestExcerpt = 100;
constexpr std::size_t kBeforeCaret = 60;
constexpr std::string_view kIndent = "  ";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::vector<std::string_view> characters_of(std::string_view line) {
  std::vector<std::string_view> characters;
  std::size_t start = 0;
  for (std::size_t i = 1; i <= line.size(); ++i) {
    if (i < line.size() && !begins_character(line[i])) continue;
    characters.push_back(line.substr(start, i - start));
    start = i;
  }
  return characters;
}

bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  return first < 0x20 || first == 0x7F;
}

}  // namespace

std::string_view SourceLines::line(std::size_t number) {
  if (number < number_) {
    number_ = 1;
    offset_ = 0;
  }
  for (; number_ < number; ++number_) {
    const auto end = text_.find('\n', offset_);
    if (end == std::string_view::npos) return {};
    offset_ = end + 1;
  }
  auto line = text_.substr(offset_, text_.find('\n', offset_) - offset_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (offset_ == 0 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  return line;
}

std::size_t field_end(std::string_view line, std::size_t column) {
  const auto rest = columns(line, column, column + kLongestExcerpt);
  if (rest.empty()) return column;
  const std::size_t bytes =
      std::max<std::size_t>(1, std::min(rest.find_first_of(";#"), rest.size()));
  return column +
         static_cast<std::size_t>(std::count_if(
             rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(bytes), begins_character));
}

std::string_view columns(std::string_view line, std::size_t begin, std::size_t end) {
  const auto offset_of = [&](std::size_t column) {
    std::size_t offset = 0;
    for (; offset < line.size(); ++offset) {
      if (begins_character(line[offset]) && --column == 0) break;
    }
    return offset;
  };
  const std::size_t first = offset_of(begin);
  return line.substr(first, offset_of(end) - first);
}

// A column is reached within as many characters, each of at most four bytes: no need to look at the
// whole of a map that is written on one line.
std::string_view excerpted_part(std::string_view line, std::size_t column) {
  return line.substr(0, 4 * (column + kLongestExcerpt));
}

std::string excerpt(std::string_view line, std::size_t column) {
  line = excerpted_part(line, column);
  const auto characters = characters_of(line);
  if (characters.empty()) return {};
  const std::size_t first = column > kBeforeCaret + 1 ? column - kBeforeCaret - 1 : 0;
  const std::size_t last = std::min(characters.size(), first + kLongestExcerpt);
  std::string text(kIndent);
  for (std::size_t i = first; i < last; ++i) {
    is_control(characters[i]) ? text += ' ' : text += characters[i];
  }
  text += '\n';
  text += kIndent;
  return text + std::string(column - 1 - first, ' ') + "^\n";
}

}  // namespace mapwright::validators
