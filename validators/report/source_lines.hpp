// Private to this folder: The lines of a map's text, by number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "mapcore/finding.hpp"

namespace mapwright::validators {

/// Gives lines in any order; going forward costs what lies between, so sorted findings cost one
/// pass.
class SourceLines {
 public:
  explicit SourceLines(std::string_view text) : text_(text) {}

  /// Line `number` (from 1) without its end; empty beyond the text.
  std::string_view line(std::size_t number);

 private:
  std::string_view text_;
  std::size_t number_ = 1;
  std::size_t offset_ = 0;
};

/// The column (from 1) behind the field that begins at `column`: of its ';' or '#', of the line's
/// end, at most 100 characters on; the one behind it where a ';' or '#' stands at `column` itself.
std::size_t field_end(std::string_view line, std::size_t column);

/// The characters of a line from one column up to another.
std::string_view columns(std::string_view line, std::size_t begin, std::size_t end);

/// The beginning of a line, as far as `excerpt` looks at it for that column.
std::string_view excerpted_part(std::string_view line, std::size_t column);

/// A line of text and a caret under one of its columns, indented by two blanks:
///
///   4.53;12.10;7.29;12.10;5;1;wall;#
///        ^
///
/// Of a long line the part around the column. Control characters and tabs become blanks, so that
/// the caret stands right. Empty for an empty line.
std::string excerpt(std::string_view line, std::size_t column);

}  // namespace mapwright::validators
