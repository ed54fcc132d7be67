// Names that rules call fields by and no layer has.
#pragma once

#include <string>
#include <vector>

#include "converter/rules/rule.hpp"
#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// One sentence for each thing that a rule wants to know of fields of which no layer the rule is
/// for has any: most are slips of the pen, and the next of the list or a default stands in.
std::vector<std::string> absent_fields(const RuleSet& rules,
                                       const std::vector<const LayerInfo*>& layers);

}  // namespace mapwright::converter
