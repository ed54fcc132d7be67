#include "converter/gdal/dxf_lines.hpp"

#include <algorithm>
#include <charconv>

namespace mapwright::converter {

std::string_view DxfLines::next_line() {
  const auto end = std::min(rest_.find('\n'), rest_.size());
  auto line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  return line;
}

std::optional<DxfPair> DxfLines::next() {
  if (rest_.empty()) return std::nullopt;
  const auto code = next_line();
  DxfPair pair;
  const auto read = std::from_chars(code.data(), code.data() + code.size(), pair.code);
  if (read.ec != std::errc()) pair.code = -1;
  pair.value = next_line();
  return pair;
}

}  // namespace mapwright::converter
