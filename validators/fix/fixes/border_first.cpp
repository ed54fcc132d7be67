#include "mapcore/text/characters.hpp"
#include "validators/fix/fixer.hpp"

namespace mapwright::validators {
namespace {

std::size_t first_character(std::string_view text) {
  return skip_blanks(text,
                     text.starts_with(text::kByteOrderMark) ? text::kByteOrderMark.size() : 0);
}

}  // namespace

Proposals fix_border_first(const FixContext& context) {
  const std::string_view text = context.document.text;
  const auto border = border_text(context.document);
  // Of several borders the first one counts; moving another would change the map.
  if (!is_found(context, FindingCode::F106) || is_found(context, FindingCode::F105) || !border) {
    return {};
  }
  const std::size_t first = first_character(text);
  std::string record(text.substr(border->begin, border->end - border->begin));
  return {{FindingCode::F106,
           {},
           "the border record moved to the beginning",
           {{first, first, record + "\n"}, removal(text, border->begin, border->end)}}};
}

}  // namespace mapwright::validators
