// Private to this folder: parts of a MapInfo table that are missing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace mapwright::converter {

/// What is missing beside a MapInfo `.tab` that has its rows and shapes in files of their own: says
/// which file, and what was in it. GDAL reads a table without shapes as one that never had any.
/// Nothing for whole tables and other files.
std::optional<std::string> missing_beside_tab(const std::filesystem::path& path);

}  // namespace mapwright::converter
