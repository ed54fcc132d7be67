#include "converter/rules/rule_reader.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "converter/rules/rule_values.hpp"
#include "converter/rules/yaml_access.hpp"

namespace mapwright::converter {
namespace {

bool looks_like_number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

std::vector<Pattern> patterns(const YAML::Node& node) {
  std::vector<Pattern> found;
  for (const auto& text : yaml_texts(node)) found.emplace_back(text);
  return found;
}

void read_unit(const YAML::Node& node, QuantityTerm& term) {
  const std::string unit = yaml_text(node);
  if (unit == "storeys")
    term.storeys = true;
  else if (unit == "m")
    term.metres_per_unit = 1.0;
  else if (unit == "cm")
    term.metres_per_unit = 0.01;
  else if (unit == "mm")
    term.metres_per_unit = 0.001;
  else if (unit == "ft")
    term.metres_per_unit = 0.3048;
  else if (unit == "in")
    term.metres_per_unit = 0.0254;
  else
    fail_at(node, "there is no unit '" + unit + "'; the units are m, cm, mm, ft, in, storeys");
}

QuantityTerm scalar_term(const YAML::Node& node) {
  QuantityTerm term;
  if (looks_like_number(yaml_text(node)))
    term.constant = yaml_number(node);
  else
    term.field = yaml_text(node);
  return term;
}

// { field: [a, b], unit: cm, minus: c, default: 3 } is one term a field and one for the default.
void append_mapped_terms(const YAML::Node& node, Quantity& quantity) {
  std::vector<std::string> fields;
  QuantityTerm term;
  std::optional<double> fallback;
  read_keys(node, "a quantity",
            {{"field", [&](const auto& n) { fields = yaml_texts(n); }},
             {"unit", [&](const auto& n) { read_unit(n, term); }},
             {"minus", [&](const auto& n) { term.minus = yaml_text(n); }},
             {"default", [&](const auto& n) { fallback = yaml_number(n); }}});
  for (const auto& field : fields) {
    term.field = field;
    quantity.terms.push_back(term);
  }
  if (!fallback) return;
  QuantityTerm constant;
  constant.constant = fallback;
  quantity.terms.push_back(constant);
}

void append_terms(const YAML::Node& node, Quantity& quantity) {
  if (node.IsMap()) return append_mapped_terms(node, quantity);
  if (!node.IsSequence()) return quantity.terms.push_back(scalar_term(node));
  for (const auto& item : node) append_terms(item, quantity);
}

void read_value(const YAML::Node& node, Quantity& quantity) {
  quantity = {};
  append_terms(node, quantity);
}

void read_value(const YAML::Node& node, SlopeQuantity& slope) {
  read_value(node, static_cast<Quantity&>(slope));
  for (auto& term : slope.terms) term.slope = true;
}

void read_value(const YAML::Node& node, Direction& direction) {
  if (node.IsScalar() && looks_like_number(node.Scalar())) {
    direction.constant_deg = yaml_number(node);
  } else {
    direction.fields = yaml_texts(node);
  }
}

void read_value(const YAML::Node& node, std::vector<std::string>& fields) {
  fields = yaml_texts(node);
}

void read_value(const YAML::Node& node, SemanticTemplate& semantic) {
  semantic.text = yaml_text(node);
}

// For for_each_value: a reader for each key.
auto append_reader(std::vector<KeyReader>& keys) {
  return [&keys](const char* key, auto& value) {
    keys.push_back({key, [&value](const YAML::Node& node) { read_value(node, value); }});
  };
}

struct Comparison {
  std::string sign;
  Condition::Test test;
};

bool read_comparison(const YAML::Node& node, const std::string& text, Condition& condition) {
  static const std::vector<Comparison> kComparisons{{"!=", Condition::Test::kNot},
                                                    {"<=", Condition::Test::kLessEqual},
                                                    {">=", Condition::Test::kGreaterEqual},
                                                    {"<", Condition::Test::kLess},
                                                    {">", Condition::Test::kGreater}};
  for (const auto& comparison : kComparisons) {
    if (text.compare(0, comparison.sign.size(), comparison.sign) != 0) continue;
    std::string rest = text.substr(comparison.sign.size());
    rest.erase(0, rest.find_first_not_of(' '));
    condition.test = comparison.test;
    if (comparison.test == Condition::Test::kNot)
      condition.patterns.emplace_back(rest);
    else if (looks_like_number(rest))
      std::from_chars(rest.data(), rest.data() + rest.size(), condition.bound);
    else
      fail_at(node, "'" + rest + "' is not a number to compare with");
    return true;
  }
  return false;
}

Condition read_condition(const std::string& field, const YAML::Node& node) {
  Condition condition;
  condition.field = field;
  if (node.IsScalar()) {
    const std::string text = node.Scalar();
    if (text == "present") condition.test = Condition::Test::kPresent;
    if (text == "absent") condition.test = Condition::Test::kAbsent;
    if (condition.test != Condition::Test::kPattern || read_comparison(node, text, condition)) {
      return condition;
    }
  }
  condition.patterns = patterns(node);
  return condition;
}

std::vector<Condition> read_where(const YAML::Node& node) {
  if (!node.IsMap()) fail_at(node, "where: expected 'field: condition' lines here");
  std::vector<Condition> conditions;
  for (const auto& entry : node) {
    conditions.push_back(read_condition(yaml_text(entry.first), entry.second));
  }
  return conditions;
}

GeometryKind read_geometry(const YAML::Node& node) {
  const std::string text = yaml_text(node);
  for (const auto kind : {GeometryKind::kPoint, GeometryKind::kLine, GeometryKind::kPolygon}) {
    if (to_string(kind) == text) return kind;
  }
  fail_at(node, "there is no geometry '" + text + "'; there are point, line and polygon");
}

std::vector<GeometryKind> read_geometries(const YAML::Node& node) {
  if (!node.IsSequence()) return {read_geometry(node)};
  std::vector<GeometryKind> kinds;
  for (const auto& item : node) kinds.push_back(read_geometry(item));
  return kinds;
}

FeatureKind read_kind(const YAML::Node& node) {
  if (const auto kind = feature_kind(yaml_text(node))) return *kind;
  fail_at(node,
          "there is no kind '" + node.Scalar() +
              "'; the kinds are obstacle, solid, room, wall, steps, stairs, ramp, border, ignore");
}

NormalAxes read_axes(const YAML::Node& node) {
  const std::string text = yaml_text(node);
  if (text == "auto") return NormalAxes::kAuto;
  if (text == "source") return NormalAxes::kSource;
  if (text == "map") return NormalAxes::kMap;
  fail_at(node, "axes: expected auto, source or map");
}

void read_normal(const YAML::Node& node, Rule& rule) {
  std::vector<KeyReader> keys;
  for_each_axis_of_normal(rule, append_reader(keys));
  read_keys(node, "normal", keys);
}

Rule read_rule(const YAML::Node& node) {
  Rule rule;
  rule.line = node.Mark().line + 1;
  bool has_kind = false;
  const auto text = [](std::string& target) {
    return [&target](const YAML::Node& n) { target = yaml_text(n); };
  };
  std::vector<KeyReader> keys{
      {"name", text(rule.name)},
      {"layer", [&](const auto& n) { rule.layers = patterns(n); }},
      {"geometry", [&](const auto& n) { rule.geometries = read_geometries(n); }},
      {"where", [&](const auto& n) { rule.where = read_where(n); }},
      {"kind", [&](const auto& n) { rule.kind = read_kind(n), has_kind = true; }},
      {"reason", text(rule.reason)},
      {"normal", [&](const auto& n) { read_normal(n, rule); }},
      {"axes", [&](const auto& n) { rule.axes = read_axes(n); }}};
  for_each_value(rule, append_reader(keys));
  read_keys(node, "a rule", keys);
  if (!has_kind) fail_at(node, "a rule without 'kind'");
  return rule;
}

void read_settings(const YAML::Node& node, RuleSettings& settings) {
  const auto metres = [](double& target) {
    return [&target](const YAML::Node& n) {
      target = yaml_number(n);
      if (target < 0.0) fail_at(n, "a length below zero");
    };
  };
  read_keys(node, "settings",
            {{"robot_height", metres(settings.robot_height_m)},
             {"default_height", metres(settings.default_height_m)},
             {"storey_height", metres(settings.storey_height_m)},
             {"rise", metres(settings.rise_m)},
             {"tread", metres(settings.tread_m)},
             {"border_margin", metres(settings.border_margin_m)}});
}

RuleSet read_rule_set(const YAML::Node& root) {
  RuleSet set;
  bool has_version = false;
  read_keys(root, "a rules file",
            {{"mapwright_rules",
              [&](const auto& n) {
                has_version = true;
                if (yaml_text(n) != "1")
                  fail_at(n, "mapwright_rules: this program knows version 1");
              }},
             {"settings", [&](const auto& n) { read_settings(n, set.settings); }},
             {"rules", [&](const auto& n) {
                if (!n.IsSequence()) fail_at(n, "rules: expected a list, each item behind '- '");
                for (const auto& item : n) set.rules.push_back(read_rule(item));
              }}});
  if (!has_version) fail_at(root, "no line 'mapwright_rules: 1': is this a rules file?");
  if (set.rules.empty()) fail_at(root, "no rules");
  return set;
}

Failure mistake(const std::string& name, const YAML::Mark& mark, const std::string& message) {
  return {FailureKind::kInput, name + ":" + std::to_string(mark.line + 1) + ":" +
                                   std::to_string(mark.column + 1) + ": error: " + message};
}

}  // namespace

Result<RuleSet> read_rules(const std::string& yaml, const std::string& name) {
  try {
    RuleSet set = read_rule_set(YAML::Load(yaml));
    set.name = name;
    for (auto& rule : set.rules) {
      if (rule.name.empty()) rule.name = "line " + std::to_string(rule.line);
    }
    return set;
  } catch (const RuleMistake& error) {
    return tl::unexpected(mistake(name, error.mark, error.message));
  } catch (const YAML::Exception& error) {
    return tl::unexpected(mistake(name, error.mark, error.msg));
  }
}

}  // namespace mapwright::converter
