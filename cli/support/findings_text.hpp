// Findings as lines of text, the way compilers write them.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/support/console.hpp"
#include "mapcore/finding.hpp"

namespace mapwright::cli {

/// How messages name an input: its path, "<stdin>" for "-".
std::string_view display_path(std::string_view path);

/// "campus.txt:41:7: error: segment 3 of obstacle 26 … [G104]"; without line and column where the
/// finding has none.
std::string finding_line(std::string_view path, const Finding& finding);

/// One line a finding, in the order given.
void write_findings(std::ostream& out, std::string_view path, const std::vector<Finding>& findings);

/// The same on standard error; with --quiet only errors.
void report_findings(Console& console, std::string_view path, const std::vector<Finding>& findings);

}  // namespace mapwright::cli
