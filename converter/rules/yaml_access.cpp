#include "converter/rules/yaml_access.hpp"

#include <charconv>
#include <cmath>

namespace mapwright::converter {

void fail_at(const YAML::Node& node, const std::string& message) {
  throw RuleMistake{node.Mark(), message};
}

std::string yaml_text(const YAML::Node& node) {
  if (!node.IsScalar()) fail_at(node, "expected one value here");
  return node.Scalar();
}

double yaml_number(const YAML::Node& node) {
  const std::string text = yaml_text(node);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    fail_at(node, "'" + text + "' is not a number");
  }
  return value;
}

std::vector<std::string> yaml_texts(const YAML::Node& node) {
  if (!node.IsSequence()) return {yaml_text(node)};
  std::vector<std::string> texts;
  for (const auto& item : node) texts.push_back(yaml_text(item));
  return texts;
}

void read_keys(const YAML::Node& node, const std::string& what,
               const std::vector<KeyReader>& keys) {
  if (!node.IsMap()) fail_at(node, what + ": expected 'key: value' lines here");
  for (const auto& entry : node) {
    const std::string key = yaml_text(entry.first);
    bool known = false;
    for (const auto& reader : keys) {
      if (reader.key != key) continue;
      known = true;
      reader.read(entry.second);
    }
    if (known) continue;
    std::string all;
    for (const auto& reader : keys) all += (all.empty() ? "" : ", ") + reader.key;
    fail_at(entry.first, what + ": there is no key '" + key + "'; the keys are " + all);
  }
}

}  // namespace mapwright::converter
