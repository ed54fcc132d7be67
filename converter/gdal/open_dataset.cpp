#include "converter/gdal/open_dataset.hpp"

#include <cpl_conv.h>

#include <filesystem>

#include "converter/gdal/csv_reader.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/messages.hpp"
#include "converter/gdal/private_copy.hpp"
#include "converter/gdal/shapefile_check.hpp"

namespace mapwright::converter {
namespace {

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
constexpr const char* kOpenOptions[] = {"NOLOCK=YES",
                                        "WRITE_GFS=NO",
                                        "LIST_ALL_TABLES=NO",
                                        "AUTODETECT_TYPE=YES",
                                        "KEEP_GEOM_COLUMNS=YES",
                                        kShapeColumnsOption,
                                        "DATE_AS_STRING=YES",
                                        nullptr};

// SQLite reads databases out of memory that the system maps, without copying page after page: a
// tenth of the time of reading a GeoPackage. Should the file be cut short meanwhile, the process
// that reads it may end, which is told as any crash of a driver is. What the person who converts
// has set counts.
class MappedDatabases {
 public:
  MappedDatabases() {
    if (CPLGetConfigOption(kOption, nullptr) == nullptr) {
      CPLSetThreadLocalConfigOption(kOption, "mmap_size=2147418112");  // SQLite's most
    }
  }
  MappedDatabases(const MappedDatabases&) = delete;
  MappedDatabases& operator=(const MappedDatabases&) = delete;
  ~MappedDatabases() { CPLSetThreadLocalConfigOption(kOption, nullptr); }

 private:
  static constexpr const char* kOption = "OGR_SQLITE_PRAGMA";
};

// The GML driver opens documents that it could not read, and says so in passing.
bool is_unread(const std::string& message) {
  return message.find("XML parsing of GML file failed") != message.npos;
}

bool is_about_open_options(const std::string& warning) {
  return warning.find("open option") != warning.npos;
}

std::string refusal(const GdalInput& input, const GdalMessages& messages, bool is_known_format) {
  const std::string reason = messages.has_error() ? ": " + messages.first_error() : std::string();
  if (is_known_format) return input.title + ": cannot be read" + reason;
  std::string text = input.title +
                     ": is no GIS file that can be read here (Shapefile, GeoPackage, GeoJSON, "
                     "FlatGeobuf, KML, GML, DXF, OSM, CSV, MapInfo, or a zip file of these)";
  if (const auto hint = driver_hint(input.path); !hint.empty()) text += "; " + hint;
  return text;
}

}  // namespace

Result<OpenedDataset> open_dataset(const GdalInput& input, const DriverNotice& notice) {
  auto shapefile_warnings = check_shapefiles(input.path);
  if (!shapefile_warnings) return tl::unexpected(shapefile_warnings.error());
  OpenedDataset opened;
  opened.warnings = *std::move(shapefile_warnings);
  std::filesystem::path readable = input.path;
  if (!input.folder.empty()) {
    auto copy = copy_database(input.path, input.folder);
    if (!copy) return tl::unexpected(copy.error());
    readable = *copy;
  }
  GdalMessages messages;
  const auto drivers = null_terminated(input.drivers);
  auto* candidate = GDALIdentifyDriverEx(readable.c_str(), GDAL_OF_VECTOR, drivers.data(), nullptr);
  if (candidate != nullptr) notice(GDALGetDriverShortName(candidate));
  const MappedDatabases mapped;
  opened.dataset.reset(GDALDataset::Open(readable.c_str(),
                                         GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                         drivers.data(), kOpenOptions, nullptr));
  if (!opened.dataset) return input_failure(refusal(input, messages, candidate != nullptr));
  if (messages.has_error() && is_unread(messages.first_error())) {
    return input_failure(input.title + ": cannot be read: " + messages.first_error());
  }
  for (auto& warning : messages.take_warnings()) {
    if (is_unread(warning)) return input_failure(input.title + ": cannot be read: " + warning);
    if (!is_about_open_options(warning)) opened.warnings.push_back(input.title + ": " + warning);
  }
  return opened;
}

}  // namespace mapwright::converter
