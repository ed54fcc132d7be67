// Private to this folder: GDAL as a reader of sources.
#pragma once

#include <string>
#include <vector>

#include "converter/isolation/isolated_reader.hpp"

namespace mapwright::converter {

/// What GDAL shall open.
struct GdalInput {
  std::string path;                  ///< what GDAL is given
  std::string title;                 ///< what people call it; for messages
  std::string folder;                ///< for a copy, where one is needed
  std::vector<std::string> drivers;  ///< allowed ones
};

/// Opens a local file or folder. The driver's name is told before it gets to see the content.
OpenedReader open_gdal(const GdalInput& input, const DriverNotice& notice);

}  // namespace mapwright::converter
