// Private to this folder: the one list of what a rule takes from fields.
#pragma once

#include "converter/rules/rule.hpp"

namespace mapwright::converter {

/// Calls `visit(key, value)` for each value of a rule (const or not) that may come from fields, by
/// its key in rules files. Who adds one adds it here: the reader of rules, the search for names
/// that no layer has and the question whether attributes are needed go by this list.
template <class SomeRule, class Visit>
void for_each_value(SomeRule& rule, const Visit& visit) {
  visit("height", rule.height);
  visit("base_height", rule.base_height);
  visit("radius", rule.radius);
  visit("rise", rule.rise);
  visit("width", rule.width);
  visit("steps", rule.steps);
  visit("slope", rule.slope);
  visit("aspect", rule.aspect);
  visit("stair_id", rule.stair_id);
  visit("step_no", rule.step_no);
  visit("direction", rule.direction);
  visit("in_out", rule.in_out);
  visit("semantic", rule.semantic);
  visit("segment_semantic", rule.segment_semantic);
}

/// The same for the keys below `normal`.
template <class SomeRule, class Visit>
void for_each_axis_of_normal(SomeRule& rule, const Visit& visit) {
  visit("x", rule.normal_x);
  visit("y", rule.normal_y);
  visit("z", rule.normal_z);
}

/// Names of the fields that a value may come from, in the order in which they count.
std::vector<std::string> fields_of(const Quantity& quantity);
std::vector<std::string> fields_of(const Direction& direction);
std::vector<std::string> fields_of(const std::vector<std::string>& names);  ///< without in and out
std::vector<std::string> fields_of(const SemanticTemplate& semantic);

}  // namespace mapwright::converter
