#include "converter/exchange/edited_semantic.hpp"

#include <algorithm>

#include "converter/exchange/fields.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::converter {
namespace {

// Tokens that a person may add by filling in the field.
constexpr std::string_view kUsualKeys[] = {semantic_key::kName, semantic_key::kLevel,
                                           semantic_key::kSource, semantic_key::kNormal};

std::string without_commas(std::string text, bool& altered) {
  const auto commas = std::count(text.begin(), text.end(), ',');
  altered = altered || commas > 0;
  std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

// The text with one of its tokens, and a comma beside it, left out.
Semantic without(const Semantic& semantic, std::string_view token) {
  std::string text = semantic.str();
  auto begin = static_cast<std::size_t>(token.data() - semantic.view().data());
  auto end = text.find(',', begin);
  end = end == text.npos ? text.size() : end + 1;
  if (end == text.size() && begin > 0) begin = text.rfind(',', begin);
  text.erase(begin == text.npos ? 0 : begin, end - (begin == text.npos ? 0 : begin));
  return text;
}

Semantic with_kind(const Semantic& semantic, const std::string& kind) {
  for (const auto token : semantic.tokens()) {
    if (token.empty() || token.find('=') != token.npos) continue;
    if (token == kind) return semantic;
    if (kind.empty()) return without(semantic, token);
    const auto begin = static_cast<std::size_t>(token.data() - semantic.view().data());
    return semantic.str().replace(begin, token.size(), kind);
  }
  if (kind.empty()) return semantic;
  return semantic.empty() ? kind : kind + "," + semantic.str();
}

Semantic with_token(const Semantic& semantic, std::string_view key, const std::string& value) {
  const auto old = semantic.value(key);
  if (old.value_or("") == value) return semantic;
  if (!value.empty()) return semantic.with_value(key, value);
  for (const auto token : semantic.tokens()) {
    if (token.substr(0, token.find('=')) == key) return without(semantic, token);
  }
  return semantic;
}

// Keys of the tokens that fields were made of.
std::vector<std::string> keys_of(const Semantic& semantic) {
  std::vector<std::string> keys(std::begin(kUsualKeys), std::end(kUsualKeys));
  for (const auto token : semantic.tokens()) {
    const auto equals = token.find('=');
    if (equals == token.npos) continue;
    std::string key(token.substr(0, equals));
    const bool is_new = std::find(keys.begin(), keys.end(), key) == keys.end();
    if (is_new && can_be_token_field(key)) keys.push_back(std::move(key));
  }
  return keys;
}

bool is_reserved(char c) {
  return c == ';' || c == '#' || c == '\n' || c == '\r';
}

}  // namespace

Semantic safe_semantic(const std::string& text, bool& altered) {
  if (std::none_of(text.begin(), text.end(), is_reserved)) return text;
  altered = true;
  return sanitized_semantic(text);
}

Semantic edited_semantic(const ExchangeFields& fields, bool& altered) {
  Semantic semantic = safe_semantic(fields.text(exchange_field::kSemantic).value_or(""), altered);
  const auto value_of = [&](std::string_view name) {
    return safe_semantic(fields.text(name).value_or(""), altered).str();
  };
  for (const auto& key : keys_of(semantic)) {
    if (!fields.has(key)) continue;
    std::string value = value_of(key);
    if (semantic.value(key).value_or("") == value) continue;
    semantic = with_token(semantic, key, without_commas(std::move(value), altered));
  }
  if (fields.has(exchange_field::kKind)) {
    std::string kind = value_of(exchange_field::kKind);
    std::replace(kind.begin(), kind.end(), '=', ' ');
    semantic = with_kind(semantic, kind);
  }
  return semantic;
}

}  // namespace mapwright::converter
