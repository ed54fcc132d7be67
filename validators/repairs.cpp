#include "validators/repairs.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "mapcore/text/fields.hpp"

namespace mapwright::validators {
namespace {

// The four numbers a record begins with, as they are written.
struct Numbers {
  std::array<std::string_view, 4> texts;
  std::size_t begin = 0, end = 0;  // offsets of all of them
};

Numbers numbers_at(std::string_view text, std::size_t at) {
  Numbers numbers;
  text::FieldWalker walker(text, at, text.size());
  for (std::size_t i = 0; i < numbers.texts.size(); ++i) {
    const text::Field field = walker.next();
    numbers.texts[i] = field.text;
    if (i == 0) numbers.begin = field.offset;
    numbers.end = field.offset + field.text.size();
  }
  return numbers;
}

TextEdit edit_of(const MapDocument& document, const Numbers& numbers,
                 const std::array<std::size_t, 4>& order) {
  std::string replacement;
  for (const std::size_t i : order) {
    if (!replacement.empty()) replacement += ';';
    replacement += numbers.texts[i];
  }
  return {document.index.place_at(document.text, numbers.begin),
          document.index.place_at(document.text, numbers.end), std::move(replacement)};
}

}  // namespace

TextEdit swapped_ends(const MapDocument& document, std::size_t obstacle, std::size_t segment) {
  const auto& index = document.index;
  const auto offset = index.segment_offset(document.text, obstacle, segment);
  return edit_of(document, numbers_at(document.text, offset), {2, 3, 0, 1});
}

std::optional<TextEdit> ordered_border(const MapDocument& document) {
  const Border& border = document.map.border;
  if (border.left == border.right || border.bottom == border.top) return std::nullopt;
  const std::string_view text = document.text;
  const auto behind_keyword = text.find(';', document.index.border_offset) + 1;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  if (border.left > border.right) std::swap(order[0], order[2]);
  if (border.top < border.bottom) std::swap(order[1], order[3]);
  return edit_of(document, numbers_at(text, behind_keyword), order);
}

}  // namespace mapwright::validators
