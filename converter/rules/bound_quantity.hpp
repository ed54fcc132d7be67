// Private to this folder: quantities of rules, bound to a layer's fields.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converter/rules/field.hpp"
#include "converter/rules/rule.hpp"

namespace mapwright::converter {

class BoundQuantity {
 public:
  BoundQuantity() = default;
  BoundQuantity(const Quantity& quantity, const std::vector<std::string>& layer_fields,
                const RuleSettings& settings);

  /// Puts the first term with a value into `value`: metres (or plain numbers, for quantities that
  /// are no lengths). Texts that are no quantity are added to `unreadable`. Most quantities have no
  /// term in most layers, and leave `value` as it is. True where the rule's number stands in for
  /// fields without a value.
  bool evaluate(const SourceFeature& feature, std::vector<std::string>& unreadable,
                std::optional<double>& value) const {
    return !terms_.empty() && evaluate_terms(feature, unreadable, value);
  }

  /// "height, top_z − base_z, 2.5": the terms this layer has.
  std::string describe() const;
  void append_fields(std::vector<std::string>& names) const;

 private:
  bool evaluate_terms(const SourceFeature& feature, std::vector<std::string>& unreadable,
                      std::optional<double>& value) const;

  struct Term {
    std::optional<double> constant;
    Field field, minus;
    bool has_minus = false;
    bool slope = false;
    double factor = 1.0;
  };
  std::vector<Term> terms_;
  bool begins_with_field_ = false;  // in the rule, whether the layer has it or not
};

}  // namespace mapwright::converter
