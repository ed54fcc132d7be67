#include "mapcore/semantic.hpp"

namespace mapwright {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

struct KeyValue {
  std::string_view key, value;
};

std::optional<KeyValue> key_value(std::string_view token) {
  const auto equals = token.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  return KeyValue{trimmed(token.substr(0, equals)), trimmed(token.substr(equals + 1))};
}

// Calls `visit(token)` for each token between the commas, trimmed, until it returns false.
template <class Visit>
void for_each_token(std::string_view text, const Visit& visit) {
  if (text.empty()) return;
  while (true) {
    const auto comma = text.find(',');
    if (!visit(trimmed(text.substr(0, comma))) || comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<std::string_view> Semantic::tokens() const {
  std::vector<std::string_view> found;
  for_each_token(view(), [&](std::string_view token) {
    found.push_back(token);
    return true;
  });
  return found;
}

std::vector<std::string_view> Semantic::labels() const {
  auto found = tokens();
  std::erase_if(found, [](std::string_view token) { return token.find('=') != token.npos; });
  return found;
}

std::optional<std::string_view> Semantic::value(std::string_view key) const {
  if (view().find(key) == std::string_view::npos) return std::nullopt;  // most ask in vain
  std::optional<std::string_view> found;
  for_each_token(view(), [&](std::string_view token) {
    if (const auto pair = key_value(token); pair && pair->key == key) found = pair->value;
    return !found;
  });
  return found;
}

bool Semantic::has_label(std::string_view label) const {
  bool found = false;
  for_each_token(view(), [&](std::string_view token) { return !(found = token == label); });
  return found;
}

Semantic Semantic::with_value(std::string_view key, std::string_view value) const {
  std::string text = str();
  const std::string pair = std::string(key) + "=" + std::string(value);
  for (const auto token : tokens()) {
    const auto old = key_value(token);
    if (!old || old->key != key) continue;
    const auto at = static_cast<std::size_t>(token.data() - view().data());
    return text.replace(at, token.size(), pair);
  }
  return text.empty() ? pair : text + "," + pair;
}

}  // namespace mapwright
