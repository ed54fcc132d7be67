// The program as a function, so that tests can call it.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.hpp"

namespace mapwright::cli {

/// Runs `mapwright ARGUMENTS...`; never throws.
ExitStatus run_program(const std::vector<std::string>& arguments, Console& console);

}  // namespace mapwright::cli
