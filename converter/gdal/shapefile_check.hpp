// The parts of a shapefile, held against each other before GDAL reads them: GDAL itself passes over
// missing parts and short files without a word.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// What is wrong with a shapefile that can be read all the same.
struct ShapefileRemarks {
  std::vector<std::string> warnings;
  bool lacks_table = false;  ///< no .dbf: shapes without attributes
};

/// Checks the shapefile whose .shp is given: the .shx is there, headers are sound, no part is
/// shorter than it says, all hold the same number of records. Fails (kInput) for the first defect.
/// `title`: what people call the .shp; for messages.
Result<ShapefileRemarks> check_shapefile(const std::filesystem::path& shp,
                                         const std::string& title);

/// Checks the .shp by itself: its header, and that it is as long as that says.
Result<void> check_shapes(const std::filesystem::path& shp, const std::string& title);

/// True if the records of the index take the .shp to its end; one made of damaged shapes stops at
/// the damage.
bool index_is_complete(const std::filesystem::path& shp);

/// True where a .shp has no .shx beside it.
bool lacks_index(const std::filesystem::path& shp);

/// The .shp files of a folder, sorted by name; where `path` is a part of
/// a shapefile, its .shp (which may be missing).
std::vector<std::filesystem::path> shapefiles_of(const std::filesystem::path& path);

}  // namespace mapwright::converter
