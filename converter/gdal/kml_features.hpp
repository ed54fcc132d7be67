// Private to this folder: what GDAL does not tell of the features of a KML document.
#pragma once

#include <memory>
#include <string>

#include "converter/source/source_reader.hpp"

namespace mapwright::converter {

/// A reader of a KML document that tells of links to features elsewhere, of 3D models and of
/// pictures, which are no obstacles although GDAL makes polygons of some. `path` may lie in GDAL's
/// memory; `title` is what people call it.
std::unique_ptr<SourceReader> with_told_elements(std::unique_ptr<SourceReader> reader,
                                                 const std::string& path, std::string title);

}  // namespace mapwright::converter
