// Words that semantic strings are made of.
#pragma once

#include <optional>
#include <string_view>

namespace mapwright::validators {

/// The known key that a key was meant to be: one slip of the pen away, or with capitals or a hyphen
/// where none belong. Nothing for keys that are known and for those that resemble none.
std::optional<std::string_view> key_meant(std::string_view key);

/// The known label (of the report, the authoring template and the built-in rules) one slip of the
/// pen away: a letter missing, too many, wrong, or two exchanged. Nothing for known labels, their
/// plurals, short words, and those that resemble none.
std::optional<std::string_view> label_meant(std::string_view label);

}  // namespace mapwright::validators
