#include "cli/support/number_table.hpp"

#include <algorithm>
#include <numeric>

#include "cli/support/text_table.hpp"

namespace mapwright::cli {
namespace {

bool has_optional(const TextTable& table, std::size_t columns,
                  const std::vector<std::string>& optional) {
  if (optional.empty()) return false;
  if (!table.has_heading()) {
    return !table.rows().empty() && table.rows()[0].fields.size() >= columns + optional.size();
  }
  const auto stands = [&](const std::string& column) { return table.column(column).has_value(); };
  if (std::none_of(optional.begin(), optional.end(), stands)) return false;
  const auto missing = std::find_if_not(optional.begin(), optional.end(), stands);
  if (missing == optional.end()) return true;
  table.fail(table.heading_line(), 0,
             "no column '" + *missing + "', which belongs to the others of its kind");
}

// Where the columns stand: by the heading, or in the order asked for.
std::vector<std::size_t> positions_of(const TextTable& table,
                                      const std::vector<std::string>& columns) {
  std::vector<std::size_t> positions(columns.size());
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  if (!table.has_heading()) return positions;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = table.column(columns[i]);
    if (!column) table.fail(table.heading_line(), 0, "no column '" + columns[i] + "'");
    positions[i] = *column;
  }
  return positions;
}

}  // namespace

std::vector<std::vector<double>> read_number_table(const std::string& path,
                                                   const std::vector<std::string>& columns) {
  return read_number_table(path, columns, {}).rows;
}

NumberTable read_number_table(const std::string& path, const std::vector<std::string>& columns,
                              const std::vector<std::string>& optional) {
  const TextTable text(path, columns);
  NumberTable table;
  table.has_optional = has_optional(text, columns.size(), optional);
  std::vector<std::string> all = columns;
  if (table.has_optional) all.insert(all.end(), optional.begin(), optional.end());
  const auto positions = positions_of(text, all);
  for (const auto& row : text.rows()) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < all.size(); ++i) {
      numbers.push_back(text.number(row, positions[i], all[i]));
    }
    table.rows.push_back(std::move(numbers));
    table.lines.push_back(row.line);
  }
  return table;
}

}  // namespace mapwright::cli
