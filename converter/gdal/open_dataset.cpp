#include "converter/gdal/open_dataset.hpp"

#include <cpl_conv.h>

#include <array>
#include <filesystem>

#include "converter/gdal/csv_reader.hpp"
#include "converter/gdal/drivers.hpp"
#include "converter/gdal/messages.hpp"
#include "converter/gdal/mif_check.hpp"
#include "converter/gdal/private_copy.hpp"
#include "converter/gdal/shapefile_check.hpp"
#include "converter/gdal/shapefile_index.hpp"
#include "converter/gdal/stored_file.hpp"
#include "converter/gdal/tab_check.hpp"
#include "mapcore/text/encoding.hpp"

namespace mapwright::converter {
namespace {

namespace fs = std::filesystem;

// What GDAL reads: the source, or a private stand-in for it.
Result<fs::path> readable_path(const GdalInput& input) {
  if (input.folder.empty()) return fs::path(input.path);
  return wants_index(input.path) ? link_shapefiles(input.path, input.folder)
                                 : copy_database(input.path, input.folder);
}

std::string title_of(const GdalInput& input, const fs::path& shp) {
  return fs::is_directory(input.path)
             ? (fs::path(input.path) / shp.filename()).string()
             : fs::path(input.title).replace_extension(shp.extension()).string();
}

// Files in memory are private already: they were unpacked from an archive.
bool is_private(const GdalInput& input) {
  return !input.folder.empty() || input.path.starts_with("/vsimem/");
}

Result<void> check_shapefiles(const GdalInput& input, const fs::path& readable,
                              OpenedDataset& opened) {
  for (const auto& shp : shapefiles_of(readable)) {
    const auto title = title_of(input, shp);
    if (auto sound = check_shapes(shp, title); !sound) return sound;
    if (lacks_index(shp) && is_private(input)) {
      if (auto made = make_index(shp, title); !made) return made;
      opened.warnings.push_back(title +
                                ": its .shx file is missing: a new index was made from its shapes, "
                                "and kept apart from the source");
    }
    auto checked = check_shapefile(shp, title);
    if (!checked) return tl::unexpected(checked.error());
    opened.warnings.insert(opened.warnings.end(), checked->warnings.begin(),
                           checked->warnings.end());
    if (checked->lacks_table) opened.bare_layers.push_back(shp.stem().string());
  }
  return {};
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

// GDAL reads no CSV, GeoJSON, DXF or MIF that is not in units of a byte, and does not say why.
std::string wide_encoding_of(const std::string& path) {
  std::array<char, 64> start;
  const auto size = StoredFile(path).read(0, start.data(), start.size());
  return std::string(text::wide_encoding({start.data(), size}));
}

std::string refusal(const GdalInput& input, const GdalMessages& messages, bool is_known_format) {
  if (const auto encoding = wide_encoding_of(input.path); !encoding.empty()) {
    return input.title + ": cannot be read, for its text is " + encoding +
           ": save it as UTF-8 (iconv -f " + encoding + " -t UTF-8)";
  }
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
  OpenedDataset opened;
  const auto readable = readable_path(input);
  if (!readable) return tl::unexpected(readable.error());
  if (auto checked = check_shapefiles(input, *readable, opened); !checked) {
    return tl::unexpected(checked.error());
  }
  if (const auto missing = missing_beside_tab(*readable)) {
    return input_failure(input.title + ": cannot be read: " + *missing);
  }
  if (mif_lacks_values(*readable)) opened.bare_layers.push_back(readable->stem().string());
  GdalMessages messages;
  const auto drivers = null_terminated(input.drivers);
  auto* candidate =
      GDALIdentifyDriverEx(readable->c_str(), GDAL_OF_VECTOR, drivers.data(), nullptr);
  if (candidate != nullptr) notice(GDALGetDriverShortName(candidate));
  const MappedDatabases mapped;
  opened.dataset.reset(GDALDataset::Open(readable->c_str(),
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
