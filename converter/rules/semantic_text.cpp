#include "converter/rules/semantic_text.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace mapwright::converter {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const auto end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == text.npos) return parts;
    begin = end + 1;
  }
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_reserved(char c) {
  return c == ';' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// The map format's own characters give way to blanks; a value behind '=' must not end its token.
// Nearly all values have none of them.
void append_safely(std::string_view value, bool is_key_value, SemanticScratch& scratch,
                   bool& altered) {
  const auto gives_way = [&](char c) { return is_reserved(c) || (is_key_value && c == ','); };
  if (std::none_of(value.begin(), value.end(), gives_way)) {
    scratch.token += trimmed(value);
    return;
  }
  altered = true;
  scratch.piece = value;
  std::replace_if(scratch.piece.begin(), scratch.piece.end(), gives_way, ' ');
  scratch.token += trimmed(scratch.piece);
}

// Whether one of the tokens of `text`, which end at `ends`, is `token`.
bool is_among(std::string_view token, const std::string& text,
              const std::vector<std::uint32_t>& ends) {
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    if (std::string_view(text).substr(begin, end - begin) == token) return true;
    begin = end + 1;
  }
  return false;
}

void append_token(std::string_view token, std::vector<std::uint32_t>& ends, std::string& text) {
  if (token.empty() || is_among(token, text, ends)) return;
  if (!text.empty()) text += ',';
  text += token;
  ends.push_back(static_cast<std::uint32_t>(text.size()));
}

void append_labels(std::string_view labels, std::vector<std::uint32_t>& ends, std::string& text) {
  while (true) {
    const auto comma = labels.find(',');
    append_token(trimmed(labels.substr(0, comma)), ends, text);
    if (comma == labels.npos) return;
    labels.remove_prefix(comma + 1);
  }
}

}  // namespace

SemanticText::SemanticText(const SemanticTemplate& semantic,
                           const std::vector<std::string>& layer_fields,
                           const std::string& layer_name) {
  if (semantic.text.empty()) return;
  for (const std::string& raw : split(semantic.text, ',')) {
    std::string part(trimmed(raw));
    if (const auto layer = part.find("{layer}"); layer != part.npos)
      part.replace(layer, 7, layer_name);
    tokens_.push_back(token_of(part, layer_fields));
  }
  take_out_constants();
}

void SemanticText::take_out_constants() {
  const auto varies = [](const Token& token) {
    return !token.is_empty && std::any_of(token.pieces.begin(), token.pieces.end(),
                                          [](const Piece& piece) { return piece.has_field; });
  };
  const auto first = std::find_if(tokens_.begin(), tokens_.end(), varies);
  const auto count = static_cast<std::size_t>(first - tokens_.begin());
  SemanticScratch scratch;
  bool altered = false;
  expand_tokens(0, count, {}, altered, scratch, constant_text_);
  constants_ = count;
  constant_ends_ = scratch.ends;
}

SemanticText::Token SemanticText::token_of(const std::string& part,
                                           const std::vector<std::string>& layer_fields) {
  Token token;
  token.is_key_value = part.find('=') != part.npos;
  std::size_t begin = 0;
  while (begin < part.size()) {
    const auto open = part.find('{', begin);
    const auto close = part.find('}', open == part.npos ? begin : open);
    Piece piece;
    piece.literal = part.substr(begin, open == part.npos ? open : open - begin);
    if (open != part.npos && close != part.npos) {
      piece.field = Field(layer_fields, part.substr(open + 1, close - open - 1));
      piece.has_field = true;
    }
    token.pieces.push_back(std::move(piece));
    if (open == part.npos || close == part.npos) break;
    begin = close + 1;
  }
  const auto first = std::find_if(token.pieces.begin(), token.pieces.end(),
                                  [](const Piece& piece) { return piece.has_field; });
  token.is_empty = first != token.pieces.end() && !first->field.exists();
  return token;
}

// Puts the token's text into the scratch; false where one of its fields is empty.
bool SemanticText::fill(const Token& token, const SourceFeature& feature, bool& altered,
                        SemanticScratch& scratch) {
  scratch.token.clear();
  for (const auto& piece : token.pieces) {
    scratch.token += piece.literal;
    if (!piece.has_field) continue;
    const auto value = piece.field.text(feature, scratch.value);
    if (!value || trimmed(*value).empty()) return false;
    append_safely(*value, token.is_key_value, scratch, altered);
  }
  return true;
}

void SemanticText::expand(const SourceFeature& feature, bool& altered, SemanticScratch& scratch,
                          std::string& text) const {
  text = constant_text_;
  scratch.ends = constant_ends_;
  expand_tokens(constants_, tokens_.size(), feature, altered, scratch, text);
}

// Appends the texts of tokens.
void SemanticText::expand_tokens(std::size_t first, std::size_t end, const SourceFeature& feature,
                                 bool& altered, SemanticScratch& scratch, std::string& text) const {
  for (std::size_t i = first; i < end; ++i) {
    const Token& token = tokens_[i];
    if (token.is_empty || !fill(token, feature, altered, scratch)) continue;
    if (token.is_key_value)
      append_token(scratch.token, scratch.ends, text);
    else
      append_labels(scratch.token, scratch.ends, text);
  }
}

std::vector<std::string> SemanticText::fields() const {
  std::vector<std::string> names;
  for (const auto& token : tokens_) {
    for (const auto& piece : token.pieces) {
      if (piece.has_field && piece.field.exists()) names.push_back(piece.field.layer_name());
    }
  }
  return names;
}

}  // namespace mapwright::converter
