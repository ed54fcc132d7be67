// What rules need besides shapes.
#pragma once

#include <string>

#include "converter/rules/rule.hpp"

namespace mapwright::converter {

/// True if a rule for layers of that name reads any field: without attributes, features may come
/// out otherwise than they should.
bool rules_read_fields(const RuleSet& rules, const std::string& layer);

}  // namespace mapwright::converter
