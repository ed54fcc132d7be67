// Which of GDAL's drivers may read a source.
#pragma once

#include <string>
#include <vector>

#include "mapcore/result.hpp"

namespace mapwright::converter {

/// Names of the drivers allowed without asking: local files of formats GIS people exchange.
const std::vector<std::string>& default_drivers();

/// Registers the default drivers and `extra` with GDAL, once per process and name, and cuts GDAL
/// off from the network. Returns all of their names. Fails (kUsage) for a driver GDAL does not
/// have.
Result<std::vector<std::string>> allow_drivers(const std::vector<std::string>& extra);

/// What to do about a file that none of the allowed drivers knows; empty where there is no advice.
std::string driver_hint(const std::string& path);

}  // namespace mapwright::converter
