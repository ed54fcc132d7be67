#include "converter/rules/rule_values.hpp"

#include <algorithm>

namespace mapwright::converter {

std::vector<std::string> fields_of(const Quantity& quantity) {
  std::vector<std::string> names;
  for (const auto& term : quantity.terms) {
    if (!term.field.empty()) names.push_back(term.field);
  }
  return names;
}

std::vector<std::string> fields_of(const Direction& direction) {
  return direction.fields;
}

// A word of its own is no field.
std::vector<std::string> fields_of(const std::vector<std::string>& names) {
  std::vector<std::string> fields = names;
  std::erase_if(fields, [](const auto& name) { return name == "indoor" || name == "outdoor"; });
  return fields;
}

std::vector<std::string> fields_of(const SemanticTemplate& semantic) {
  const auto& text = semantic.text;
  std::vector<std::string> names;
  for (auto at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
    const auto end = text.find('}', at);
    if (end == text.npos) break;
    auto name = text.substr(at + 1, end - at - 1);
    if (name != "layer") names.push_back(std::move(name));
  }
  return names;
}

}  // namespace mapwright::converter
