// Private to this folder: what GDAL does not tell of the features of a GML document.
#pragma once

#include <memory>
#include <string>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// A reader of a GML document whose features tell when they have more geometries than the one that
/// GDAL reads, and whose layers tell when their geometries name several reference systems. `path`
/// may lie in GDAL's memory.
std::unique_ptr<SourceReader> with_told_geometries(std::unique_ptr<SourceReader> reader,
                                                   const std::string& path);

}  // namespace mapwright::converter
