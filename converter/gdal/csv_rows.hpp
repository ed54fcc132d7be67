// Private to this folder: the rows of a table, as far as they tell that it was cut short.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace mapwright::converter {

/// The number of the last row, from 1 after the heading, where the text ends within it: without an
/// end of line, and in quotes or before the last of the heading's columns. Commas, semicolons, tabs
/// and bars may separate. `path` may lie in GDAL's memory.
std::optional<std::size_t> row_cut_short(const std::string& path);

}  // namespace mapwright::converter
