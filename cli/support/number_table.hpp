// Tables of numbers: CSV files of poses, queries, odometry.
#pragma once

#include <string>
#include <vector>

namespace mapwright::cli {

/// Rows of a CSV file ("-": standard input), each with one finite number for each of `columns`, in
/// that order.
///
/// A first line that holds a word names the columns: they may stand in any order then, among others
/// that are passed over. Without such a line the columns are those asked for. Blank lines and lines
/// that begin with '#' are passed over. Throws Error (kInput) with file, line and field for what is
/// not a number, or for too few fields.
std::vector<std::vector<double>> read_number_table(const std::string& path,
                                                   const std::vector<std::string>& columns);

struct NumberTable {
  std::vector<std::vector<double>> rows;
  std::vector<std::size_t> lines;  ///< 1-based line of each row
  bool has_optional = false;       ///< rows hold the optional columns too, behind the others
};

/// The same for tables that may have more columns: all of `optional`, or none. They are there if
/// the first line names all of them or, in a table without such a line, if the first row has room.
NumberTable read_number_table(const std::string& path, const std::vector<std::string>& columns,
                              const std::vector<std::string>& optional);

}  // namespace mapwright::cli
