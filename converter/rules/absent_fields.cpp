#include "converter/rules/absent_fields.hpp"

#include <algorithm>
#include <iterator>

#include "converter/rules/field.hpp"
#include "converter/rules/rule_values.hpp"

namespace mapwright::converter {
namespace {

using Names = std::vector<std::string>;

// Alternatives, of which one will do, and what they are for.
struct Wanted {
  std::string what;
  Names fields;
};

// Of alternatives one will do; each field of a label is wanted by itself.
void append_wanted(const std::string& what, const SemanticTemplate& semantic,
                   std::vector<Wanted>& wanted) {
  for (auto& name : fields_of(semantic)) wanted.push_back({what, {std::move(name)}});
}

template <class Value>
void append_wanted(const std::string& what, const Value& value, std::vector<Wanted>& wanted) {
  wanted.push_back({what, fields_of(value)});
}

std::vector<Wanted> wanted_by(const Rule& rule) {
  std::vector<Wanted> wanted;
  for_each_value(rule,
                 [&](const char* key, const auto& value) { append_wanted(key, value, wanted); });
  for_each_axis_of_normal(rule, [&](const char* axis, const auto& names) {
    append_wanted(std::string("normal ") + axis, names, wanted);
  });
  for (const auto& condition : rule.where) {
    if (condition.test == Condition::Test::kAbsent) continue;
    wanted.push_back({"condition", {condition.field}});
  }
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
