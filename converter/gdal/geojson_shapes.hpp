// Private to this folder: which shapes of a GeoJSON document are none.
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace mapwright::converter {

/// By the feature's place in the document, from 0: what is wrong with its geometry by RFC 7946, a
/// type that does not exist or coordinates that are not nested as the type wants. GDAL makes a
/// feature without geometry of such a one, or leaves the part out, and says nothing. The document
/// is read as far as it is JSON; `path` may lie in GDAL's memory.
std::map<std::size_t, std::string> broken_shapes(const std::string& path);

}  // namespace mapwright::converter
