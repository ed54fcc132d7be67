#include "converter/gdal/open_dataset.hpp"

#include <filesystem>

#include "converter/gdal/messages.hpp"
#include "converter/gdal/shapefile_check.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

// GDAL takes many texts for names of data sets; a source is a file or folder of this machine.
Result<void> check_path(const std::string& path) {
  if (path.find("/vsi") != path.npos || path.find("://") != path.npos) {
    return usage_failure(path +
                         ": is no local file or folder: remote and virtual sources are refused; "
                         "fetch or unpack it first");
  }
  std::error_code error;
  if (!fs::exists(path, error)) return input_failure(path + ": there is no such file or folder");
  if (fs::is_directory(path, error)) {
    fs::directory_iterator entries(path, error);
    if (error) return input_failure(path + ": cannot be read: " + error.message());
    if (entries == fs::directory_iterator()) return input_failure(path + ": the folder is empty");
    return {};
  }
  const auto size = fs::file_size(path, error);
  if (error) return input_failure(path + ": cannot be read: " + error.message());
  if (size == 0) return input_failure(path + ": the file is empty");
  return {};
}

Result<std::vector<std::string>> check_shapefiles(const std::string& path) {
  std::vector<std::string> warnings;
  for (const auto& shp : shapefiles_of(path)) {
    auto checked = check_shapefile(shp);
    if (!checked) return checked;
    warnings.insert(warnings.end(), checked->begin(), checked->end());
  }
  return warnings;
}

std::vector<const char*> null_terminated(const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const auto& text : texts) pointers.push_back(text.c_str());
  pointers.push_back(nullptr);
  return pointers;
}

// Options that keep drivers from locking the source and from writing beside it. Each driver takes
// its own and would warn of the others', so the warnings about them are dropped by the caller.
constexpr const char* kOpenOptions[] = {"NOLOCK=YES",           "WRITE_GFS=NO",
                                        "LIST_ALL_TABLES=NO",   "AUTODETECT_TYPE=YES",
                                        "KEEP_GEOM_COLUMNS=NO", nullptr};

bool is_about_open_options(const std::string& warning) {
  return warning.find("open option") != warning.npos;
}

std::string refusal(const std::string& path, const GdalMessages& messages) {
  std::string text = path +
                     ": is no GIS file that can be read here (Shapefile, GeoPackage, GeoJSON, "
                     "FlatGeobuf, KML, GML, DXF, OSM, CSV, MapInfo)";
  if (messages.has_error()) text += ": " + messages.first_error();
  return text;
}

}  // namespace

Result<OpenedDataset> open_dataset(const std::string& path,
                                   const std::vector<std::string>& drivers) {
  if (auto checked = check_path(path); !checked) return tl::unexpected(checked.error());
  auto shapefile_warnings = check_shapefiles(path);
  if (!shapefile_warnings) return tl::unexpected(shapefile_warnings.error());

  OpenedDataset opened;
  opened.warnings = *std::move(shapefile_warnings);
  fs::path readable = path;
  if (reading_leaves_traces(path)) {
    auto folder = PrivateFolder::create();
    if (!folder) return tl::unexpected(folder.error());
    auto copy = copy_database(path, **folder);
    if (!copy) return tl::unexpected(copy.error());
    opened.folder = *std::move(folder);
    readable = *copy;
  }
  GdalMessages messages;
  opened.dataset.reset(GDALDataset::Open(readable.c_str(),
                                         GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                         null_terminated(drivers).data(), kOpenOptions, nullptr));
  if (!opened.dataset) return input_failure(refusal(path, messages));
  for (auto& warning : messages.take_warnings()) {
    if (!is_about_open_options(warning)) opened.warnings.push_back(path + ": " + warning);
  }
  return opened;
}

}  // namespace mapwright::converter
