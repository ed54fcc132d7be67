// Numbers as text.
#pragma once

#include <string>

namespace mapwright::converter {

/// Shortest decimals that read back as the same double; never "-0".
std::string shortest_decimal(double value);

}  // namespace mapwright::converter
