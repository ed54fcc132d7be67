// What changed between two texts, as `diff -u` shows it.
#pragma once

#include <string>
#include <string_view>

namespace mapwright::cli {

/// A unified diff with three lines of context, which `patch` applies; empty for equal texts.
/// Lines end at LF; a last line without one is marked. Of texts that differ in very many lines the
/// diff may be longer than need be.
std::string unified_diff(std::string_view before, std::string_view after,
                         std::string_view before_name, std::string_view after_name);

}  // namespace mapwright::cli
