// Private to this folder: `where` conditions, bound to a layer's fields.
#pragma once

#include <string>
#include <vector>

#include "converter/rules/field.hpp"
#include "converter/rules/rule.hpp"

namespace mapwright::converter {

class BoundCondition {
 public:
  BoundCondition(const Condition& condition, const std::vector<std::string>& layer_fields)
      : condition_(&condition), field_(layer_fields, condition.field) {}

  bool holds(const SourceFeature& feature) const;

  /// False where the layer lacks the field, so that no feature can fulfil the condition.
  bool can_hold() const {
    return field_.exists() || condition_->test == Condition::Test::kAbsent ||
           condition_->test == Condition::Test::kNot;
  }
  const Field& field() const { return field_; }

 private:
  bool fits_a_pattern(const std::string& value) const;

  const Condition* condition_;
  Field field_;
};

}  // namespace mapwright::converter
