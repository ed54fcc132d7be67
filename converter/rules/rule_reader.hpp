// Reads rules files.
#pragma once

#include <string>

#include "converter/rules/rule.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

/// Reads rules from YAML (docs/rules.md). `name` is what messages call the text. Fails (kInput)
/// with "NAME:LINE:COLUMN: error: …" for the first mistake: bad YAML, unknown keys, wrong values.
Result<RuleSet> read_rules(const std::string& yaml, const std::string& name);

/// Names of the built-in sets: auto, cadastre, mapwright, osm.
const std::vector<std::string>& builtin_rule_sets();

/// YAML text of a built-in set; empty for a name there is none of.
std::string_view builtin_rules(std::string_view name);

}  // namespace mapwright::converter
