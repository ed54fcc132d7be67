// Private to this folder: GeoJSON, held against its own rules.
#pragma once

#include <memory>

#include "converter/gdal/gdal_reader.hpp"

namespace mapwright::converter {

/// `reader`, which read the document at `path`, with what GDAL passes over: a shape that is none by
/// the rules of GeoJSON is a broken feature.
std::unique_ptr<SourceReader> with_checked_shapes(std::unique_ptr<SourceReader> reader,
                                                  std::string path);

}  // namespace mapwright::converter
