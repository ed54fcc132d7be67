// Private to this folder: a DXF file as the pairs of lines it consists of.
#pragma once

#include <optional>
#include <string_view>

namespace mapwright::converter {

/// A group code and its value, without blanks around it.
struct DxfPair {
  int code = -1;
  std::string_view value;
};

class DxfLines {
 public:
  /// Points into `text`.
  explicit DxfLines(std::string_view text) : rest_(text) {}

  /// The next pair; nothing at the end. A code that is no number is -1.
  std::optional<DxfPair> next();

 private:
  std::string_view next_line();

  std::string_view rest_;
};

}  // namespace mapwright::converter
