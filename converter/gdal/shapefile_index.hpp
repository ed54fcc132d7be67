// Indexes (.shx) of shapefiles that lack theirs.
#pragma once

#include <filesystem>
#include <string>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// True where a shapefile, or one of a folder of them, has no index.
bool wants_index(const std::filesystem::path& path);

/// Links the parts of a shapefile, or the files of a folder of them, into `folder`, so that an
/// index can be made there and nothing is written beside the source. Returns what to read instead.
Result<std::filesystem::path> link_shapefiles(const std::filesystem::path& path,
                                              const std::filesystem::path& folder);

/// Makes the index of a .shp beside it, which must be a private place (GDAL does, from the lengths
/// that the records of the .shp state). Fails (kInput) where records cannot be told apart. `title`:
/// what people call the .shp; for messages.
Result<void> make_index(const std::filesystem::path& shp, const std::string& title);

}  // namespace mapwright::converter
