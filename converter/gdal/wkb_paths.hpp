// Private to this folder: well-known binary (ISO 19125) taken apart into paths.
#pragma once

#include <cstddef>
#include <span>

#include "converter/source/feature.hpp"

namespace mapwright::converter {

/// Appends the paths of a geometry, as append_paths does of the geometry that GDAL makes of it,
/// without making one. False, with `paths` half filled, for what only GDAL should judge: curves,
/// surfaces, collections of collections, empty parts, other byte orders, bytes that end too early.
bool append_wkb(std::span<const std::byte> wkb, SourceGeometry& paths);

}  // namespace mapwright::converter
