// Tables: CSV files as rows of fields.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mapwright::cli {

/// The rows of a CSV file without quoting, as texts.
class TextTable {
 public:
  struct Row {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> fields;
  };

  /// Reads a file ("-": standard input). Blank lines and lines that begin with '#' are passed over;
  /// white space around fields is. A first line that holds one of `words` is the heading. Throws
  /// Error (kInput) where the file cannot be read.
  TextTable(const std::string& path, const std::vector<std::string>& words);

  bool has_heading() const { return has_heading_; }

  /// Position of a column by the heading; nothing where there is none of that name.
  std::optional<std::size_t> column(const std::string& name) const;

  const std::vector<Row>& rows() const { return rows_; }

  /// The finite number in a field (from 0) that is called `name` in messages. Throws Error
  /// (kInput).
  double number(const Row& row, std::size_t field, const std::string& name) const;

  /// Throws Error (kInput) with file, line and field (from 0).
  [[noreturn]] void fail(std::size_t line, std::size_t field, const std::string& what) const;

  std::size_t heading_line() const { return heading_line_; }

 private:
  std::string path_;
  std::vector<std::string> heading_;
  std::vector<Row> rows_;
  std::size_t heading_line_ = 0;
  bool has_heading_ = false;
};

}  // namespace mapwright::cli
