#include "converter/rules/absent_fields.hpp"

#include <algorithm>
#include <iterator>

#include "converter/rules/field.hpp"

namespace mapwright::converter {
namespace {

using Names = std::vector<std::string>;

// Alternatives, of which one will do, and what they are for.
struct Wanted {
  std::string what;
  Names fields;
};

Names fields_of(const Quantity& quantity) {
  Names names;
  for (const auto& term : quantity.terms) {
    if (!term.field.empty()) names.push_back(term.field);
  }
  return names;
}

Names placeholders_of(const std::string& text) {
  Names names;
  for (auto at = text.find('{'); at != text.npos; at = text.find('{', at + 1)) {
    const auto end = text.find('}', at);
    if (end == text.npos) break;
    const auto name = text.substr(at + 1, end - at - 1);
    if (name != "layer") names.push_back(name);
  }
  return names;
}

std::vector<Wanted> wanted_by(const Rule& rule) {
  std::vector<Wanted> wanted{{"height", fields_of(rule.height)},
                             {"base_height", fields_of(rule.base_height)},
                             {"radius", fields_of(rule.radius)},
                             {"rise", fields_of(rule.rise)},
                             {"width", fields_of(rule.width)},
                             {"steps", fields_of(rule.steps)},
                             {"slope", fields_of(rule.slope)},
                             {"aspect", fields_of(rule.aspect)},
                             {"stair_id", rule.stair_id},
                             {"step_no", rule.step_no},
                             {"direction", rule.direction},
                             {"normal", rule.normal_x},
                             {"in_out", rule.in_out}};
  std::erase_if(wanted.back().fields,
                [](const std::string& name) { return name == "indoor" || name == "outdoor"; });
  for (const auto& condition : rule.where) {
    if (condition.test == Condition::Test::kAbsent) continue;
    wanted.push_back({"condition", {condition.field}});
  }
  for (const auto& name : placeholders_of(rule.semantic.text))
    wanted.push_back({"semantic", {name}});
  for (const auto& name : placeholders_of(rule.segment_semantic.text))
    wanted.push_back({"segment_semantic", {name}});
  return wanted;
}

bool is_for(const Rule& rule, const LayerInfo& layer) {
  return rule.layers.empty() ||
         std::any_of(rule.layers.begin(), rule.layers.end(),
                     [&](const Pattern& pattern) { return pattern.matches(layer.name); });
}

bool has_one(const LayerInfo& layer, const Names& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return Field(layer.fields, name).exists(); });
}

std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

std::vector<std::string> absent_fields(const RuleSet& rules,
                                       const std::vector<const LayerInfo*>& layers) {
  std::vector<std::string> said;
  for (const auto& rule : rules.rules) {
    std::vector<const LayerInfo*> own;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(own),
                 [&](const LayerInfo* layer) { return is_for(rule, *layer); });
    if (own.empty()) continue;  // rules may be for other sources too
    for (const auto& wanted : wanted_by(rule)) {
      const bool is_there =
          wanted.fields.empty() || std::any_of(own.begin(), own.end(), [&](const LayerInfo* layer) {
            return has_one(*layer, wanted.fields);
          });
      if (is_there) continue;
      said.push_back(rules.name + ":" + std::to_string(rule.line) + ": rule '" + rule.name +
                     "' takes its " + wanted.what + " from " + listed(wanted.fields) +
                     ", which no layer it is for has");
    }
  }
  return said;
}

}  // namespace mapwright::converter
