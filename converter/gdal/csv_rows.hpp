// Private to this folder: the rows of a table, as far as they tell that values are missing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mapwright::converter {

/// Numbers of rows count from 1 after the heading.
struct RowFaults {
  std::optional<std::size_t> cut_short;  ///< the last row, where the text ends within it: without
                                         ///< an end of line, in quotes or before the last column
  std::vector<std::size_t> too_long;  ///< rows with values beyond the last column, ascending
};

/// Looks at a table whose heading has commas, semicolons, tabs or bars between its columns. `path`
/// may lie in GDAL's memory.
RowFaults faults_of_rows(const std::string& path);

}  // namespace mapwright::converter
