#include "cli/support/text_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "cli/support/error.hpp"
#include "cli/support/files.hpp"
#include "cli/support/findings_text.hpp"
#include "mapcore/text/encoding.hpp"

namespace mapwright::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const auto end = text.find(separator);
    parts.emplace_back(trimmed(text.substr(0, end)));
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

// What a spreadsheet wrote that this is not: empty if nothing is known.
std::string advice_on(const std::string& field) {
  if (field.find(';') != field.npos) return "; fields are separated by commas, not semicolons";
  if (field.find('\t') != field.npos) return "; fields are separated by commas, not tabs";
  if (field.find('"') != field.npos) return "; fields stand without quotes";
  return {};
}

// A number that no table can hold ("nan") is a bad row; a word is a heading.
bool is_heading(const std::vector<std::string>& fields, const std::vector<std::string>& words) {
  return std::any_of(fields.begin(), fields.end(), [&](const std::string& field) {
    return std::find(words.begin(), words.end(), field) != words.end();
  });
}

}  // namespace

TextTable::TextTable(const std::string& path, const std::vector<std::string>& words)
    : path_(display_path(path)) {
  const std::string text = read_file(path);
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  if (const auto encoding = text::wide_encoding(rest); !encoding.empty()) {
    throw Error(ExitStatus::kInput,
                path_ + ": the file is " + std::string(encoding) + "; save it as UTF-8");
  }
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const auto end = rest.find('\n');
    const std::string_view content = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    if (content.empty() || content.starts_with('#')) continue;
    auto fields = split(content, ',');
    if (rows_.empty() && !has_heading_ && is_heading(fields, words)) {
      has_heading_ = true;
      heading_line_ = line;
      heading_ = std::move(fields);
    } else {
      rows_.push_back({line, std::move(fields)});
    }
  }
}

std::optional<std::size_t> TextTable::column(const std::string& name) const {
  const auto found = std::find(heading_.begin(), heading_.end(), name);
  if (found == heading_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - heading_.begin());
}

double TextTable::number(const Row& row, std::size_t field, const std::string& name) const {
  if (field >= row.fields.size()) {
    fail(row.line, row.fields.size() - 1, "the row ends before '" + name + "'");
  }
  const auto number = finite_number(row.fields[field]);
  if (!number) {
    const std::string& text = row.fields[field];
    fail(row.line, field, name + ": '" + text + "' is not a finite number" + advice_on(text));
  }
  return *number;
}

void TextTable::fail(std::size_t line, std::size_t field, const std::string& what) const {
  throw Error(ExitStatus::kInput, path_ + ":" + std::to_string(line) + ": field " +
                                      std::to_string(field + 1) + ": " + what);
}

}  // namespace mapwright::cli
