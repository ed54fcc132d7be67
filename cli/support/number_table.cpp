#include "cli/support/number_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"

namespace mapwright::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

// A number that no table can hold ("nan") is a bad row; a word is a heading.
bool is_heading(const std::vector<std::string_view>& fields,
                const std::vector<std::string>& columns) {
  return std::any_of(fields.begin(), fields.end(), [&](std::string_view field) {
    return std::find(columns.begin(), columns.end(), field) != columns.end();
  });
}

class TableReader {
 public:
  TableReader(const std::string& path, const std::vector<std::string>& columns,
              const std::vector<std::string>& optional)
      : path_(display_path(path)), columns_(columns), optional_(optional) {}

  void line(std::string_view text) {
    ++line_;
    text = trimmed(text);
    if (text.empty() || text.starts_with('#')) return;
    const auto fields = split(text, ',');
    if (!positions_.empty()) return row(fields);
    if (is_heading(fields, columns_)) return heading(fields);
    if (fields.size() >= columns_.size() + optional_.size()) want_optional();
    positions_.resize(columns_.size());
    std::iota(positions_.begin(), positions_.end(), std::size_t{0});
    row(fields);
  }

  NumberTable take() { return std::move(table_); }

 private:
  void want_optional() {
    table_.has_optional = !optional_.empty();
    columns_.insert(columns_.end(), optional_.begin(), optional_.end());
  }

  void heading(const std::vector<std::string_view>& fields) {
    const auto is_named = [&](const std::string& column) {
      return std::find(fields.begin(), fields.end(), column) != fields.end();
    };
    if (std::all_of(optional_.begin(), optional_.end(), is_named)) want_optional();
    positions_.resize(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto found = std::find(fields.begin(), fields.end(), columns_[i]);
      if (found == fields.end()) fail(1, "no column '" + columns_[i] + "'");
      positions_[i] = static_cast<std::size_t>(found - fields.begin());
    }
  }

  void row(const std::vector<std::string_view>& fields) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::size_t position = positions_[i];
      if (position >= fields.size()) {
        fail(fields.size(), "the row ends before '" + columns_[i] + "'");
      }
      const auto number = finite_number(fields[position]);
      if (!number) {
        fail(position + 1,
             columns_[i] + ": '" + std::string(fields[position]) + "' is not a finite number");
      }
      numbers.push_back(*number);
    }
    table_.rows.push_back(std::move(numbers));
    table_.lines.push_back(line_);
  }

  [[noreturn]] void fail(std::size_t field, const std::string& what) const {
    throw Error(ExitStatus::kInput, path_ + ":" + std::to_string(line_) + ": field " +
                                        std::to_string(field) + ": " + what);
  }

  std::string path_;
  std::vector<std::string> columns_;
  const std::vector<std::string>& optional_;
  std::vector<std::size_t> positions_;  ///< of the columns; empty before the first line
  NumberTable table_;
  std::size_t line_ = 0;
};

}  // namespace

std::vector<std::vector<double>> read_number_table(const std::string& path,
                                                   const std::vector<std::string>& columns) {
  return read_number_table(path, columns, {}).rows;
}

NumberTable read_number_table(const std::string& path, const std::vector<std::string>& columns,
                              const std::vector<std::string>& optional) {
  const std::string text = read_file(path);
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  TableReader reader(path, columns, optional);
  while (!rest.empty()) {
    const auto end = rest.find('\n');
    reader.line(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
  }
  return reader.take();
}

}  // namespace mapwright::cli
