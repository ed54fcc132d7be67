#include "converter/exchange/decimal_text.hpp"

#include <charconv>
#include <iterator>

namespace mapwright::converter {

std::string shortest_decimal(double value) {
  char buffer[32];
  const auto end =
      std::to_chars(std::begin(buffer), std::end(buffer), value == 0.0 ? 0.0 : value).ptr;
  return {std::begin(buffer), end};
}

}  // namespace mapwright::converter
