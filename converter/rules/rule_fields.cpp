#include "converter/rules/rule_fields.hpp"

#include <algorithm>

namespace mapwright::converter {
namespace {

bool reads_field(const Quantity& quantity) {
  return std::any_of(quantity.terms.begin(), quantity.terms.end(),
                     [](const QuantityTerm& term) { return !term.field.empty(); });
}

bool reads_field(const SemanticTemplate& semantic) {
  for (auto at = semantic.text.find('{'); at != std::string::npos;
       at = semantic.text.find('{', at + 1)) {
    if (semantic.text.compare(at, 7, "{layer}") != 0) return true;
  }
  return false;
}

// A word of its own ("indoor") is no field.
bool reads_field(const std::vector<std::string>& in_out) {
  return std::any_of(in_out.begin(), in_out.end(),
                     [](const std::string& name) { return name != "indoor" && name != "outdoor"; });
}

bool reads_field(const Rule& rule) {
  if (rule.kind == FeatureKind::kObstacle || !rule.where.empty()) return true;
  if (rule.kind == FeatureKind::kIgnore || rule.kind == FeatureKind::kBorder) return false;
  for (const auto* quantity : {&rule.height, &rule.base_height, &rule.radius, &rule.rise,
                               &rule.width, &rule.steps, &rule.slope, &rule.aspect}) {
    if (reads_field(*quantity)) return true;
  }
  for (const auto* names : {&rule.stair_id, &rule.step_no, &rule.direction, &rule.normal_x}) {
    if (!names->empty()) return true;
  }
  return reads_field(rule.in_out) || reads_field(rule.semantic) ||
         reads_field(rule.segment_semantic);
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
