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
  /// term in most layers, and leave `value` as it is.
  void evaluate(const SourceFeature& feature, std::vector<std::string>& unreadable,
                std::optional<double>& value) const {
    if (!terms_.empty()) value = evaluate_terms(feature, unreadable);
  }

  /// "height, top_z − base_z, 2.5": the terms this layer has.
  std::string describe() const;
  void append_fields(std::vector<std::string>& names) const;

 private:
  std::optional<double> evaluate_terms(const SourceFeature& feature,
                                       std::vector<std::string>& unreadable) const;

  struct Term {
    std::optional<double> constant;
    Field field, minus;
    bool has_minus = false;
    bool slope = false;
    double factor = 1.0;
  };
  std::vector<Term> terms_;
};

}  // namespace mapwright::converter
