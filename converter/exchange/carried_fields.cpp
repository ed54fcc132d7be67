#include "converter/exchange/carried_fields.hpp"

#include <algorithm>
#include <charconv>

#include "converter/exchange/decimal_text.hpp"
#include "converter/exchange/fields.hpp"

namespace mapwright::converter {
namespace {

void append_encoded(std::string& to, std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7F && c != '%' && c != '+') {
      to += c;
      continue;
    }
    to += '%';
    to += kDigits[byte >> 4U];
    to += kDigits[byte & 0xFU];
  }
}

std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

std::string text_of(const FieldValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value)) return shortest_decimal(*real);
  return std::get<std::string>(value);
}

// The words of a text; those that were cut joined again.
std::vector<std::string> words_of(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string> words;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(kBlanks, begin)) != text.npos;) {
    const auto end = std::min(text.find_first_of(kBlanks, begin), text.size());
    const auto word = text.substr(begin, end - begin);
    if (word.front() == '+' && !words.empty())
      words.back() += word.substr(1);
    else if (word.find('=') != word.npos)
      words.emplace_back(word);
    begin = end;
  }
  return words;
}

}  // namespace

std::vector<std::string> carried_items(const std::vector<std::string>& names,
                                       const std::vector<FieldValue>& values) {
  std::vector<std::string> items;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_null(values[i])) continue;
    std::string item = names[i] + "=";
    append_encoded(item, text_of(values[i]));
    items.push_back(std::move(item));
  }
  return items;
}

std::optional<std::map<std::string, std::string, std::less<>>> read_carried_items(
    std::string_view text) {
  const auto mark = text.find(kCarrierMark);
  if (mark == text.npos) return std::nullopt;
  std::map<std::string, std::string, std::less<>> fields;
  for (const auto& word : words_of(text.substr(mark + kCarrierMark.size()))) {
    const auto equals = word.find('=');
    fields.emplace(word.substr(0, equals), decoded(std::string_view(word).substr(equals + 1)));
  }
  return fields;
}

}  // namespace mapwright::converter
