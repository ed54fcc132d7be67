// What a benchmark ran on: a figure without it means nothing.
#pragma once

#include <string>

namespace mapwright::bench {

/// Processor, number of cores, compiler and flags, one line each.
std::string machine_description();

}  // namespace mapwright::bench
