// Private to this folder: what stands for coordinates in XML documents and is no number.
#pragma once

#include <optional>
#include <string>

namespace mapwright::converter {

/// The first word among a KML or GML document's coordinates (`coordinates`, `pos`, `posList`) that
/// is no number: GDAL takes it for 0. Says line and word. `path` may lie in GDAL's memory. Nothing
/// where the document ends the parsing before: what is wrong with it is the driver's to say.
std::optional<std::string> word_among_coordinates(const std::string& path);

}  // namespace mapwright::converter
