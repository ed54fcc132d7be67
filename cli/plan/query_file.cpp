#include "cli/plan/query_file.hpp"

#include "cli/support/text_table.hpp"

namespace mapwright::cli {
namespace {

// An end of a query by the columns of the heading.
Place read_end(const TextTable& table, const TextTable::Row& row, const std::string& end) {
  if (const auto name = table.column(end)) {
    if (*name < row.fields.size() && !row.fields[*name].empty()) {
      return {std::nullopt, row.fields[*name]};
    }
  }
  const auto coordinate = [&](const std::string& column) {
    const auto field = table.column(column);
    if (!field) table.fail(row.line, 0, "no '" + end + "', and no column '" + column + "'");
    return table.number(row, *field, column);
  };
  return {Point{coordinate(end + "_x"), coordinate(end + "_y")}, {}};
}

StartAndGoal read_bare_row(const TextTable& table, const TextTable::Row& row) {
  if (row.fields.size() == 2) return {{std::nullopt, row.fields[0]}, {std::nullopt, row.fields[1]}};
  const auto number = [&](std::size_t field, const char* name) {
    return table.number(row, field, name);
  };
  return {{Point{number(0, "start_x"), number(1, "start_y")}, {}},
          {Point{number(2, "goal_x"), number(3, "goal_y")}, {}}};
}

}  // namespace

std::vector<StartAndGoal> read_queries(const std::string& path) {
  const TextTable table(path, {"start", "goal", "start_x", "start_y", "goal_x", "goal_y"});
  std::vector<StartAndGoal> queries;
  for (const auto& row : table.rows()) {
    queries.push_back(table.has_heading() ? StartAndGoal{read_end(table, row, "start"),
                                                         read_end(table, row, "goal")}
                                          : read_bare_row(table, row));
  }
  return queries;
}

}  // namespace mapwright::cli
