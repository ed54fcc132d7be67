// What `mapwright convert` says about a conversion.
#pragma once

#include <cstddef>
#include <string>

#include "cli/support/console.hpp"
#include "converter/pipeline/convert.hpp"

namespace mapwright::cli {

/// Warnings, and how many features were written, changed and dropped for which reasons.
void report_conversion(const converter::Conversion& conversion, Console& console);

/// Reasons of severity error: data that is lost. Prints the first twenty and returns how many.
std::size_t report_losses(const converter::Ledger& ledger, Console& console);

/// What `--strict` refuses: features changed, or dropped for a reason worse than a note. The same.
std::size_t report_repairs(const converter::Ledger& ledger, Console& console);

}  // namespace mapwright::cli
