// The parts of a shapefile, held against each other before GDAL reads them: GDAL itself passes over
// missing parts and short files without a word.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// Checks the shapefile whose .shp is given: .shx and .dbf are there, headers are sound, no part is
/// shorter than it says, all hold the same number of records. Returns warnings (no .cpg); fails
/// (kInput) for the first defect.
Result<std::vector<std::string>> check_shapefile(const std::filesystem::path& shp);

/// The .shp files of a folder, sorted by name; where `path` is a part of
/// a shapefile, its .shp (which may be missing).
std::vector<std::filesystem::path> shapefiles_of(const std::filesystem::path& path);

}  // namespace mapwright::converter
