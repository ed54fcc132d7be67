#include "converter/rules/bound_condition.hpp"

namespace mapwright::converter {

bool BoundCondition::fits_a_pattern(const std::string& value) const {
  const std::string plain = folded(value);
  for (const auto& pattern : condition_->patterns) {
    if (pattern.matches_folded(plain)) return true;
  }
  return false;
}

bool BoundCondition::holds(const SourceFeature& feature) const {
  using Test = Condition::Test;
  const auto text = field_.text(feature);
  switch (condition_->test) {
    case Test::kPattern:
      return text && fits_a_pattern(*text);
    case Test::kNot:
      return !text || !fits_a_pattern(*text);
    case Test::kPresent:
      return text.has_value();
    case Test::kAbsent:
      return !text.has_value();
    default:
      break;
  }
  const auto value = field_.length_m(feature, 1.0);
  if (!value) return false;
  switch (condition_->test) {
    case Test::kLess:
      return *value < condition_->bound;
    case Test::kLessEqual:
      return *value <= condition_->bound;
    case Test::kGreater:
      return *value > condition_->bound;
    default:
      return *value >= condition_->bound;
  }
}

}  // namespace mapwright::converter
