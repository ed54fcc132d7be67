// Private to this folder: what GDAL does not tell of a MapInfo interchange file.
#pragma once

#include <filesystem>

namespace mapwright::converter {

/// True for a .mif file that states columns and lacks the .mid file with their values: GDAL reads
/// features whose fields are all empty.
bool mif_lacks_values(const std::filesystem::path& path);

}  // namespace mapwright::converter
