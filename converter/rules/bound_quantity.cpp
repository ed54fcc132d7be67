#include "converter/rules/bound_quantity.hpp"

#include <charconv>
#include <iterator>

#include "converter/rules/length_text.hpp"

namespace mapwright::converter {
namespace {

std::string shortest(double value) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), value);
  return {std::begin(buffer), result.ptr};
}

std::optional<double> read(const Field& field, double factor, const SourceFeature& feature,
                           std::vector<std::string>& unreadable) {
  const auto value = field.length_m(feature, factor);
  if (!value && field.has_value(feature)) {
    unreadable.push_back(field.layer_name() + " '" + field.text(feature).value_or("") + "'");
  }
  return value;
}

// "up" and "down" say which way and not how steeply: they are understood, but no number.
std::optional<double> read_slope(const Field& field, const SourceFeature& feature,
                                 std::vector<std::string>& unreadable) {
  if (const auto number = field.number(feature)) return number;
  const auto text = field.text(feature);
  if (!text || *text == "up" || *text == "down") return std::nullopt;
  const auto slope = slope_deg_from_text(*text);
  if (!slope) unreadable.push_back(field.layer_name() + " '" + *text + "'");
  return slope;
}

}  // namespace

BoundQuantity::BoundQuantity(const Quantity& quantity, const std::vector<std::string>& layer_fields,
                             const RuleSettings& settings)
    : begins_with_field_(!quantity.empty() && !quantity.terms.front().constant) {
  for (const auto& term : quantity.terms) {
    Term bound;
    bound.constant = term.constant;
    bound.factor = term.storeys ? settings.storey_height_m : term.metres_per_unit;
    if (!term.constant) bound.field = Field(layer_fields, term.field);
    if (!term.minus.empty()) bound.minus = Field(layer_fields, term.minus);
    bound.has_minus = !term.minus.empty();
    bound.slope = term.slope;
    const bool can_have_value = bound.field.exists() && (!bound.has_minus || bound.minus.exists());
    if (bound.constant || can_have_value) terms_.push_back(std::move(bound));
  }
}

bool BoundQuantity::evaluate_terms(const SourceFeature& feature,
                                   std::vector<std::string>& unreadable,
                                   std::optional<double>& value) const {
  for (const auto& term : terms_) {
    if (term.constant) {
      value = term.constant;
      return begins_with_field_;
    }
    value = term.slope ? read_slope(term.field, feature, unreadable)
                       : read(term.field, term.factor, feature, unreadable);
    if (!value) continue;
    if (!term.has_minus) return false;
    const auto less = read(term.minus, term.factor, feature, unreadable);
    if (less) {
      *value -= *less;
      return false;
    }
  }
  value.reset();
  return false;
}

std::string BoundQuantity::describe() const {
  std::string text;
  for (const auto& term : terms_) {
    if (!text.empty()) text += ", else ";
    if (term.constant)
      text += shortest(*term.constant);
    else
      text += term.field.layer_name();
    if (term.has_minus) text += " - " + term.minus.layer_name();
    if (term.factor != 1.0) text += " x " + shortest(term.factor);
    if (term.constant) break;
  }
  return text;
}

void BoundQuantity::append_fields(std::vector<std::string>& names) const {
  for (const auto& term : terms_) {
    if (term.field.exists()) names.push_back(term.field.layer_name());
    if (term.minus.exists()) names.push_back(term.minus.layer_name());
  }
}

}  // namespace mapwright::converter
