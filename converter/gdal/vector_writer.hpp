// Writes layers through a driver of GDAL. No type of GDAL leaves this folder.
#pragma once

#include <string>
#include <vector>

#include "converter/exporters/gis/gis_layers.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct WriteTarget {
  std::string path;    ///< nothing may stand there yet, or an empty file
  std::string driver;  ///< GDAL's name for it
  std::string crs;     ///< WKT, or anything `parse_crs` reads; empty: plain local metres
  std::vector<std::string> layer_options;  ///< "KEY=VALUE"
  std::size_t most_text_bytes =
      0;  ///< longer texts go on in further fields (`continued_field`); 0: there is no limit
};

/// Writes the layers in their order. Fails (kOutput) where the driver does, whatever it says: a
/// feature or a value that is not written as it is fails too.
Result<void> write_layers(const std::vector<GisLayer>& layers, const WriteTarget& target);

}  // namespace mapwright::converter
