#include "converter/rules/semantic_text.hpp"

#include <algorithm>
#include <optional>

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

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool is_reserved(char c) {
  return c == ';' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

// The map format's own characters give way to blanks; a value behind '=' must not end its token.
std::string safe(std::string value, bool is_key_value, bool& altered) {
  for (char& c : value) {
    if (!is_reserved(c) && !(is_key_value && c == ',')) continue;
    c = ' ';
    altered = true;
  }
  return trimmed(value);
}

void append_token(const std::string& token, std::vector<std::string>& tokens) {
  if (token.empty() || std::find(tokens.begin(), tokens.end(), token) != tokens.end()) return;
  tokens.push_back(token);
}

}  // namespace

SemanticText::SemanticText(const SemanticTemplate& semantic,
                           const std::vector<std::string>& layer_fields,
                           const std::string& layer_name) {
  if (semantic.text.empty()) return;
  for (std::string part : split(semantic.text, ',')) {
    part = trimmed(part);
    if (const auto layer = part.find("{layer}"); layer != part.npos)
      part.replace(layer, 7, layer_name);
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
    tokens_.push_back(std::move(token));
  }
}

std::string SemanticText::expand(const SourceFeature& feature, bool& altered) const {
  std::vector<std::string> tokens;
  for (const auto& token : tokens_) {
    std::string text;
    bool complete = true;
    for (const auto& piece : token.pieces) {
      text += piece.literal;
      if (!piece.has_field) continue;
      const auto value = piece.field.text(feature);
      complete = complete && value && !trimmed(*value).empty();
      if (complete) text += safe(*value, token.is_key_value, altered);
    }
    if (!complete) continue;
    if (token.is_key_value)
      append_token(text, tokens);
    else
      for (const auto& label : split(text, ',')) append_token(trimmed(label), tokens);
  }
  std::string all;
  for (const auto& token : tokens) all += (all.empty() ? "" : ",") + token;
  return all;
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
