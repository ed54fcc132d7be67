#include "mapcore/text/record_shapes.hpp"

#include <algorithm>

#include "mapcore/text/characters.hpp"
#include "mapcore/text/decimal.hpp"

namespace mapwright::text {
namespace {

bool is_integer(std::string_view text) {
  return read_integer(text).status == NumberStatus::kOk;
}

bool equal_but_case(std::string_view text, std::string_view lower_case) {
  return std::equal(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                    [](char c, char lower) { return (c | ' ') == lower; });
}

bool is_keyword(std::string_view word) {
  return equal_but_case(word, "border") || equal_but_case(word, "obstacle");
}

bool are_next(FieldWalker& walker, int count, bool (*is_one)(std::string_view)) {
  for (int i = 0; i < count; ++i) {
    if (walker.done() || !is_one(walker.next().text)) return false;
  }
  return true;
}

}  // namespace

bool is_number(std::string_view text) {
  return read_number(text).status == NumberStatus::kOk;
}

std::string_view first_word(std::string_view text) {
  const auto gap = std::find_if(text.begin(), text.end(), is_blank);
  return text.substr(0, static_cast<std::size_t>(gap - text.begin()));
}

std::string_view last_word(std::string_view text) {
  const auto gap = std::find_if(text.rbegin(), text.rend(), is_blank);
  return text.substr(static_cast<std::size_t>(text.rend() - gap));
}

std::string_view keyword_of(std::string_view field) {
  while (!field.empty()) {
    const auto word = last_word(field);
    if (is_keyword(word)) return word;
    field = trimmed(field.substr(0, field.size() - word.size()));
  }
  return {};
}

bool follows_obstacle(FieldWalker walker) {
  if (!are_next(walker, 3, is_integer) || walker.done()) return false;
  const Field semantic = walker.next();
  return semantic.closed && !is_number(semantic.text);
}

bool follows_border(FieldWalker walker) {
  return are_next(walker, 4, is_number);
}

bool looks_like_segment(FieldWalker walker) {
  int numbers = 0;
  for (int i = 0; i < 5 && !walker.done(); ++i) numbers += is_number(walker.next().text) ? 1 : 0;
  return numbers >= 4;
}

bool holds_a_number(FieldWalker walker) {
  while (!walker.done()) {
    if (is_number(walker.next().text)) return true;
  }
  return false;
}

bool holds_obstacle_values(FieldWalker walker) {
  return are_next(walker, 3, is_integer);
}

bool holds_segment_values(FieldWalker walker) {
  if (!are_next(walker, 5, is_number)) return false;
  const auto in_out = walker.next().text;
  return in_out == "0" || in_out == "1";
}

}  // namespace mapwright::text
