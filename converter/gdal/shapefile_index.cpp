#include "converter/gdal/shapefile_index.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <algorithm>

#include "converter/gdal/messages.hpp"
#include "converter/gdal/shapefile_check.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

Failure no_link(const fs::path& file, const std::error_code& error) {
  return {FailureKind::kInput,
          file.string() + ": cannot be linked into a temporary folder: " + error.message()};
}

}  // namespace

bool wants_index(const fs::path& path) {
  const auto shapefiles = shapefiles_of(path);
  return std::any_of(shapefiles.begin(), shapefiles.end(), lacks_index);
}

Result<fs::path> link_shapefiles(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  const auto place = fs::absolute(is_folder ? path : path.parent_path() / ".", error);
  fs::directory_iterator entries(place, error);
  if (error) return tl::unexpected(no_link(place, error));
  for (const auto& entry : entries) {
    const auto& file = entry.path();
    std::error_code no_file;  // a link that leads nowhere
    if ((!is_folder && file.stem() != path.stem()) || !entry.is_regular_file(no_file)) continue;
    fs::create_symlink(file, folder / file.filename(), error);
    if (error) return tl::unexpected(no_link(file, error));
  }
  return is_folder ? folder : folder / path.filename();
}

Result<void> make_index(const fs::path& shp, const std::string& title) {
  const GdalMessages messages;
  const char* const drivers[] = {"ESRI Shapefile", nullptr};
  const CPLConfigOptionSetter restore("SHAPE_RESTORE_SHX", "YES", false);
  const GDALDatasetUniquePtr opened(
      GDALDataset::Open(shp.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (opened && index_is_complete(shp)) return {};
  return input_failure(title + ": its .shx file is missing, and it cannot be made anew" +
                       (messages.has_error() ? " (" + messages.first_error() + ")" : "") +
                       ": the lengths of its records are damaged; get a complete copy");
}

}  // namespace mapwright::converter
