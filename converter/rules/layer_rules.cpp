#include "converter/rules/layer_rules.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "converter/rules/bound_condition.hpp"
#include "converter/rules/bound_quantity.hpp"
#include "converter/rules/semantic_text.hpp"

namespace mapwright::converter {
namespace {

constexpr std::array<std::string_view, 13> kIndoorWords{
    "0",     "false",   "indoor", "indoors",   "in",     "inside", "interior",
    "inner", "interno", "innen",  "interieur", "binnen", "room"};

std::string first_text(const std::vector<Field>& fields, const SourceFeature& feature) {
  for (const auto& field : fields) {
    if (auto text = field.text(feature)) return *std::move(text);
  }
  return {};
}

std::optional<double> first_number(const std::vector<Field>& fields, const SourceFeature& feature) {
  for (const auto& field : fields) {
    if (const auto number = field.number(feature)) return number;
  }
  return std::nullopt;
}

// A rule with its fields looked up in the layer.
class BoundRule {
 public:
  BoundRule(const Rule& rule, const LayerInfo& layer, const RuleSettings& settings,
            const Pattern* layer_pattern);

  const Rule& rule() const { return *rule_; }
  bool can_match(GeometryKind layer_geometry) const;
  bool matches(const SourceFeature& feature, GeometryKind geometry) const;
  void read(const SourceFeature& feature, SemanticScratch& scratch, Meaning& meaning) const;
  std::string explain() const;
  void append_fields(std::vector<std::string>& names) const;

 private:
  bool fits_geometry(GeometryKind geometry) const;
  InOut in_out(const SourceFeature& feature) const;
  InOut in_out_named(const std::string& value) const;
  void read_direction(const SourceFeature& feature, Meaning& meaning) const;
  void read_normal(const SourceFeature& feature, Meaning& meaning) const;
  std::vector<std::pair<std::string, const BoundQuantity*>> quantities() const;

  const Rule* rule_;
  const Pattern* layer_pattern_;  // that fits the layer; null: the rule is for every layer
  std::vector<BoundCondition> where_;
  BoundQuantity height_, base_height_, radius_, rise_, width_, steps_, slope_, aspect_;
  std::vector<Field> in_out_;
  InOut default_in_out_ = InOut::kOutdoor;  // where no field says it
  SemanticText semantic_, segment_semantic_;
  std::vector<Field> stair_id_, step_no_, direction_, normal_x_, normal_y_, normal_z_;
};

BoundRule::BoundRule(const Rule& rule, const LayerInfo& layer, const RuleSettings& settings,
                     const Pattern* layer_pattern)
    : rule_(&rule),
      layer_pattern_(layer_pattern),
      height_(rule.height, layer.fields, settings),
      base_height_(rule.base_height, layer.fields, settings),
      radius_(rule.radius, layer.fields, settings),
      rise_(rule.rise, layer.fields, settings),
      width_(rule.width, layer.fields, settings),
      steps_(rule.steps, layer.fields, settings),
      slope_(rule.slope, layer.fields, settings),
      aspect_(rule.aspect, layer.fields, settings),
      in_out_(existing_fields(layer.fields, rule.in_out)),
      semantic_(rule.semantic, layer.fields, layer.name),
      segment_semantic_(rule.segment_semantic, layer.fields, layer.name),
      stair_id_(existing_fields(layer.fields, rule.stair_id)),
      step_no_(existing_fields(layer.fields, rule.step_no)),
      direction_(existing_fields(layer.fields, rule.direction.fields)),
      normal_x_(existing_fields(layer.fields, rule.normal_x)),
      normal_y_(existing_fields(layer.fields, rule.normal_y)),
      normal_z_(existing_fields(layer.fields, rule.normal_z)) {
  for (const auto& condition : rule.where) where_.emplace_back(condition, layer.fields);
  default_in_out_ = in_out_named({});
}

bool BoundRule::fits_geometry(GeometryKind geometry) const {
  const auto& allowed = rule_->geometries;
  return allowed.empty() || std::find(allowed.begin(), allowed.end(), geometry) != allowed.end();
}

bool BoundRule::can_match(GeometryKind layer_geometry) const {
  const bool open = layer_geometry == GeometryKind::kMixed;
  return (open || fits_geometry(layer_geometry)) &&
         std::all_of(where_.begin(), where_.end(), [](const auto& c) { return c.can_hold(); });
}

bool BoundRule::matches(const SourceFeature& feature, GeometryKind geometry) const {
  return fits_geometry(geometry) &&
         std::all_of(where_.begin(), where_.end(), [&](const auto& c) { return c.holds(feature); });
}

InOut BoundRule::in_out(const SourceFeature& feature) const {
  return in_out_.empty() ? default_in_out_ : in_out_named(first_text(in_out_, feature));
}

InOut BoundRule::in_out_named(const std::string& value) const {
  const std::string word =
      value.empty() && !rule_->in_out.empty() ? rule_->in_out.back() : folded(value);
  const bool indoor =
      std::find(kIndoorWords.begin(), kIndoorWords.end(), word) != kIndoorWords.end();
  return indoor ? InOut::kIndoor : InOut::kOutdoor;
}

void BoundRule::read_direction(const SourceFeature& feature, Meaning& meaning) const {
  const auto& constant_deg = rule_->direction.constant_deg;
  if (constant_deg) meaning.direction_deg = constant_deg;
  if (direction_.empty()) return;
  const std::string word = folded(first_text(direction_, feature));
  if (word == "up") meaning.upwards = true;
  if (word == "down") meaning.upwards = false;
  // OSM's "8%" and "-12°": uphill along the drawing, or against it.
  if (word.ends_with('%') || word.ends_with("\u00b0")) {
    const double steepness = std::strtod(word.c_str(), nullptr);
    if (steepness != 0.0) meaning.upwards = steepness > 0.0;
  }
  if (const auto degrees = first_number(direction_, feature)) meaning.direction_deg = degrees;
}

void BoundRule::read_normal(const SourceFeature& feature, Meaning& meaning) const {
  if (normal_x_.empty() || normal_y_.empty() || normal_z_.empty()) return;
  const auto x = first_number(normal_x_, feature);
  const auto y = first_number(normal_y_, feature);
  const auto z = first_number(normal_z_, feature);
  if (x && y && z) meaning.normal = Normal{*x, *y, *z};
}

void BoundRule::read(const SourceFeature& feature, SemanticScratch& scratch,
                     Meaning& meaning) const {
  meaning.clear();
  meaning.rule = rule_;
  meaning.height_is_fallback = height_.evaluate(feature, meaning.unreadable, meaning.height_m);
  base_height_.evaluate(feature, meaning.unreadable, meaning.base_height_m);
  radius_.evaluate(feature, meaning.unreadable, meaning.radius_m);
  rise_.evaluate(feature, meaning.unreadable, meaning.rise_m);
  width_.evaluate(feature, meaning.unreadable, meaning.width_m);
  steps_.evaluate(feature, meaning.unreadable, meaning.steps);
  slope_.evaluate(feature, meaning.unreadable, meaning.slope_deg);
  aspect_.evaluate(feature, meaning.unreadable, meaning.aspect_deg);
  if (!step_no_.empty()) meaning.step_no = first_number(step_no_, feature);
  if (!stair_id_.empty()) meaning.stair_id = first_text(stair_id_, feature);
  meaning.in_out = in_out(feature);
  read_direction(feature, meaning);
  read_normal(feature, meaning);
  semantic_.expand(feature, meaning.semantic_altered, scratch, meaning.semantic);
  segment_semantic_.expand(feature, meaning.semantic_altered, scratch, meaning.segment_semantic);
}

std::vector<std::pair<std::string, const BoundQuantity*>> BoundRule::quantities() const {
  return {{"height", &height_}, {"base height", &base_height_},
          {"radius", &radius_}, {"rise", &rise_},
          {"width", &width_},   {"steps", &steps_},
          {"slope", &slope_},   {"aspect", &aspect_}};
}

std::string BoundRule::explain() const {
  std::string text =
      "rule '" + rule_->name + "' makes " + std::string(to_string(rule_->kind)) + ": ";
  text += layer_pattern_ == nullptr ? "it is for every layer"
                                    : "the layer's name fits '" + layer_pattern_->text() + "'";
  for (const auto& condition : where_) text += ", where " + condition.field().layer_name();
  for (const auto& [name, quantity] : quantities()) {
    if (const auto terms = quantity->describe(); !terms.empty())
      text += "; " + name + " from " + terms;
  }
  const auto add_fields = [&](const std::string& name, const std::vector<Field>& fields) {
    for (const auto& field : fields) text += "; " + name + " from " + field.layer_name();
  };
  add_fields("stairs", stair_id_);
  add_fields("order", step_no_);
  add_fields("direction", direction_);
  add_fields("normal", normal_x_);
  add_fields("in/out", in_out_);
  std::string labels;
  for (const auto& name : semantic_.fields()) labels += (labels.empty() ? "" : ", ") + name;
  if (!labels.empty()) text += "; labels from " + labels;
  if (!rule_->reason.empty()) text += " (" + rule_->reason + ")";
  return text;
}

void BoundRule::append_fields(std::vector<std::string>& names) const {
  for (const auto& [name, quantity] : quantities()) quantity->append_fields(names);
  for (const auto& condition : where_) names.push_back(condition.field().layer_name());
  for (const auto* fields :
       {&in_out_, &stair_id_, &step_no_, &direction_, &normal_x_, &normal_y_, &normal_z_}) {
    for (const auto& field : *fields) names.push_back(field.layer_name());
  }
  for (const auto* semantic : {&semantic_, &segment_semantic_}) {
    for (auto& name : semantic->fields()) names.push_back(std::move(name));
  }
}

}  // namespace

struct LayerRules::Impl {
  std::vector<BoundRule> rules;
  SemanticScratch scratch;
};

LayerRules::LayerRules(const RuleSet& rules, const LayerInfo& layer)
    : impl_(std::make_unique<Impl>()) {
  const std::string layer_name = folded(layer.name);
  for (const auto& rule : rules.rules) {
    const auto fits = [&](const Pattern& pattern) { return pattern.matches_folded(layer_name); };
    const auto pattern = std::find_if(rule.layers.begin(), rule.layers.end(), fits);
    if (!rule.layers.empty() && pattern == rule.layers.end()) continue;
    BoundRule bound(rule, layer, rules.settings, rule.layers.empty() ? nullptr : &*pattern);
    if (bound.can_match(layer.geometry)) impl_->rules.push_back(std::move(bound));
  }
}

LayerRules::LayerRules(LayerRules&&) noexcept = default;
LayerRules& LayerRules::operator=(LayerRules&&) noexcept = default;
LayerRules::~LayerRules() = default;

void LayerRules::interpret(const SourceFeature& feature, GeometryKind geometry,
                           Meaning& meaning) const {
  for (const auto& bound : impl_->rules) {
    if (bound.matches(feature, geometry)) return bound.read(feature, impl_->scratch, meaning);
  }
  meaning.clear();
}

std::vector<std::string> LayerRules::fields() const {
  std::vector<std::string> names;
  for (const auto& bound : impl_->rules) {
    if (bound.rule().kind == FeatureKind::kObstacle) return {};
    bound.append_fields(names);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::erase(names, "");
  return names;
}

std::vector<std::string> LayerRules::explain() const {
  std::vector<std::string> lines;
  for (const auto& bound : impl_->rules) lines.push_back(bound.explain());
  return lines;
}

}  // namespace mapwright::converter
