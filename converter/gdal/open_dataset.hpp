// Private to this folder: from a path to a data set that GDAL has open for reading only.
#pragma once

#include <gdal_priv.h>

#include <memory>
#include <string>
#include <vector>

#include "converter/gdal/private_copy.hpp"
#include "mapcore/result.hpp"

namespace mapwright::converter {

struct OpenedDataset {
  std::unique_ptr<PrivateFolder> folder;  // outlives the data set, which may lie in it
  GDALDatasetUniquePtr dataset;
  std::vector<std::string> warnings;
};

/// Opens a local file or folder with one of the drivers named.
Result<OpenedDataset> open_dataset(const std::string& path,
                                   const std::vector<std::string>& drivers);

}  // namespace mapwright::converter
