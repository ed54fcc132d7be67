#include "converter/rules/rule_fields.hpp"

#include <algorithm>

#include "converter/rules/rule_values.hpp"

namespace mapwright::converter {
namespace {

bool reads_field(const Rule& rule) {
  if (rule.kind == FeatureKind::kObstacle || !rule.where.empty()) return true;
  if (rule.kind == FeatureKind::kIgnore || rule.kind == FeatureKind::kBorder) return false;
  bool reads = false;
  const auto look = [&](const char*, const auto& value) {
    reads = reads || !fields_of(value).empty();
  };
  for_each_value(rule, look);
  for_each_axis_of_normal(rule, look);
  return reads;
}

bool is_for(const Rule& rule, const std::string& layer) {
  return rule.layers.empty() || std::any_of(rule.layers.begin(), rule.layers.end(),
                                            [&](const Pattern& p) { return p.matches(layer); });
}

}  // namespace

bool rules_read_fields(const RuleSet& rules, const std::string& layer) {
  return std::any_of(rules.rules.begin(), rules.rules.end(),
                     [&](const Rule& rule) { return is_for(rule, layer) && reads_field(rule); });
}

}  // namespace mapwright::converter
