// Private to this folder: from a path to a data set that GDAL has open for reading only.
#pragma once

#include <gdal_priv.h>

#include <string>
#include <vector>

#include "converter/gdal/gdal_reader.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct OpenedDataset {
  GDALDatasetUniquePtr dataset;
  std::vector<std::string> warnings;
  std::vector<std::string> bare_layers;  ///< shapefiles without attributes
};

/// Opens a local file or folder with one of the drivers named.
Result<OpenedDataset> open_dataset(const GdalInput& input, const DriverNotice& notice);

}  // namespace mapwright::converter
