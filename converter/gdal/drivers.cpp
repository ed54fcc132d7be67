#include "converter/gdal/drivers.hpp"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <mutex>
#include <string_view>

#include "converter/gdal/messages.hpp"

namespace mapwright::converter {
namespace {

struct AllowedDriver {
  const char* name;
  void (*enlist)();
};

// One line a driver. LIBKML comes before KML, which knows no attributes but name and description.
constexpr AllowedDriver kAllowed[] = {
    {"ESRI Shapefile", RegisterOGRShape},
    {"GPKG", RegisterOGRGeoPackage},
    {"GeoJSON", RegisterOGRGeoJSON},
    {"FlatGeobuf", RegisterOGRFlatGeobuf},
    {"LIBKML", RegisterOGRLIBKML},
    {"KML", RegisterOGRKML},
    {"GML", RegisterOGRGML},
    {"DXF", RegisterOGRDXF},
    {"CSV", RegisterOGRCSV},
    {"MapInfo File", RegisterOGRTAB},
};

CPLHTTPResult* refuse_http(const char* url, CSLConstList, GDALProgressFunc, void*,
                           CPLHTTPFetchWriteFunc, void*, void*) {
  CPLError(CE_Warning, CPLE_NotSupported, "the source asks for %s: no network is used", url);
  return nullptr;
}

// A source is a stranger's file: it must not make the program fetch, write beside it, or open
// others.
void seal() {
  CPLHTTPSetFetchCallback(refuse_http, nullptr);
  CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "{none}");
  CPLSetConfigOption("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");  // how long it is, beside it
  CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "NO");
  CPLSetConfigOption("OGR_ORGANIZE_POLYGONS", "DEFAULT");
  CPLSetConfigOption("OGR_SQLITE_LOAD_EXTENSIONS", nullptr);
  CPLSetConfigOption("OGR_GEOJSON_MAX_OBJ_SIZE", "2000");
  CPLSetConfigOption("OSM_USE_CUSTOM_INDEXING", "NO");  // takes nodes in any order
  CPLSetConfigOption("GML_SKIP_CORRUPTED_FEATURES", "NO");
  CPLSetConfigOption("DXF_INCLUDE_RAW_CODE_VALUES", "YES");  // what `export` wrote of an entity
  CPLSetConfigOption("CPL_TMPDIR", std::filesystem::temp_directory_path().c_str());
}

void enlist_defaults() {
  static std::once_flag once;
  std::call_once(once, [] {
    seal();
    for (const auto& driver : kAllowed) driver.enlist();
  });
}

void enlist_everything() {
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

// Formats of local files that people come with, and GDAL reads if it is allowed to.
constexpr std::array<std::string_view, 11> kOfferedDrivers{
    "SQLite", "TopoJSON", "ESRIJSON",    "GeoJSONSeq", "CAD", "DGN",
    "GPX",    "JML",      "OpenFileGDB", "PGDUMP",     "S57"};

}  // namespace

const std::vector<std::string>& default_drivers() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& driver : kAllowed) all.emplace_back(driver.name);
    return all;
  }();
  return names;
}

Result<std::vector<std::string>> allow_drivers(const std::vector<std::string>& extra) {
  enlist_defaults();
  auto names = default_drivers();
  for (const auto& name : extra) {
    enlist_everything();
    if (GetGDALDriverManager()->GetDriverByName(name.c_str()) == nullptr) {
      return usage_failure("--allow-driver: GDAL has no driver '" + name +
                           "'; 'ogrinfo --formats' lists them");
    }
    names.push_back(name);
  }
  return names;
}

std::string driver_hint(const std::string& path) {
  enlist_everything();
  const GdalMessages quiet;
  auto* driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr);
  if (driver == nullptr) return {};
  const std::string name = GDALGetDriverShortName(driver);
  if (name == "OGR_VRT") return "it points to other files: give those instead";
  if (std::find(kOfferedDrivers.begin(), kOfferedDrivers.end(), name) == kOfferedDrivers.end()) {
    return {};
  }
  return "GDAL's driver " + name + " may read it: allow it with --allow-driver " + name;
}

}  // namespace mapwright::converter
