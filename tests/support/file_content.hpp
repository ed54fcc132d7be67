// What a file holds.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace mapwright::test {

/// All bytes of a file; none where it cannot be read.
inline std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace mapwright::test
