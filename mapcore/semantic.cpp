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

}  // namespace

std::vector<std::string_view> Semantic::tokens() const {
  std::vector<std::string_view> found;
  std::string_view rest = view();
  if (rest.empty()) return found;
  while (true) {
    const auto comma = rest.find(',');
    found.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return found;
    rest.remove_prefix(comma + 1);
  }
}

std::vector<std::string_view> Semantic::labels() const {
  auto found = tokens();
  std::erase_if(found, [](std::string_view token) { return token.find('=') != token.npos; });
  return found;
}

std::optional<std::string_view> Semantic::value(std::string_view key) const {
  for (const auto token : tokens()) {
    if (const auto pair = key_value(token); pair && pair->key == key) return pair->value;
  }
  return std::nullopt;
}

bool Semantic::has_label(std::string_view label) const {
  for (const auto token : tokens()) {
    if (token == label) return true;
  }
  return false;
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
