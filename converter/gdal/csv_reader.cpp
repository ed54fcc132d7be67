#include "converter/gdal/csv_reader.hpp"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "converter/gdal/csv_rows.hpp"
#include "converter/gdal/geometry_paths.hpp"
#include "converter/gdal/messages.hpp"
#include "converter/gdal/stored_file.hpp"
#include "converter/source/wrapped_reader.hpp"

namespace mapwright::converter {
namespace {

constexpr std::array<const char*, 5> kNames{"WKT", "geom", "geometry", "the_geom", "wkt_geom"};
constexpr std::size_t kQuoted = 40;

bool is_shape_column(const std::string& field) {
  const bool numbered = STARTS_WITH_CI(field.c_str(), "_WKT");
  return numbered || std::any_of(kNames.begin(), kNames.end(),
                                 [&](const char* name) { return EQUAL(name, field.c_str()); });
}

// "geometry" may be the name of a column that says what the shape is like.
bool looks_like_a_shape(const std::string& text) {
  static constexpr std::array<const char*, 15> kStarts{
      "POINT", "LINESTRING",    "POLYGON",           "MULTI",     "GEOMETRYCOLLECTION",
      "CURVE", "COMPOUNDCURVE", "CIRCULARSTRING",    "SURFACE",   "TRIANGLE",
      "TIN",   "SRID=",         "POLYHEDRALSURFACE", "{\"type\"", "010"};
  return std::any_of(kStarts.begin(), kStarts.end(),
                     [&](const char* start) { return EQUALN(text.c_str(), start, strlen(start)); });
}

class CsvReader : public WrappedReader {
 public:
  CsvReader(const std::string& title, std::string path, std::unique_ptr<SourceReader> table)
      : WrappedReader(std::move(table)), path_(std::move(path)) {
    for (const auto& layer : layers()) {
      auto& columns = columns_.emplace_back();
      for (std::size_t i = 0; i < layer.fields.size(); ++i) {
        if (is_shape_column(layer.fields[i])) columns.push_back(i);
      }
      if (!columns.empty()) continue;
      warn(title +
           ": no column of it holds shapes: name the one with well-known text WKT (geom, geometry, "
           "the_geom and wkt_geom are known too)");
    }
  }

  Result<std::size_t> read(std::size_t layer, const ReadOptions& options,
                           const FeatureVisitor& visit) override {
    ReadOptions with_shapes = options;
    for (const std::size_t column : columns_[layer]) {
      if (!options.fields.empty()) with_shapes.fields.push_back(layers()[layer].fields[column]);
    }
    const auto faults = faults_of_rows(path_);
    return behind().read(layer, with_shapes, [&](SourceFeature& feature) {
      if (feature.geometry.type.empty()) look_again(layer, options.sagitta_m, feature);
      tell_faults(faults, feature);
      visit(feature);
    });
  }

 private:
  // GDAL's ids are the numbers of rows.
  static void tell_faults(const RowFaults& faults, SourceFeature& feature) {
    const auto row = static_cast<std::size_t>(feature.fid);
    if (faults.cut_short == row && feature.broken.empty()) {
      feature.broken = "the file ends within its row";
    }
    if (std::binary_search(faults.too_long.begin(), faults.too_long.end(), row)) {
      feature.warnings.emplace_back(
          "its row has more values than the table has columns: quote texts and numbers that hold "
          "the separator");
    }
  }

  // A text that GDAL made nothing of.
  void look_again(std::size_t layer, double sagitta_m, SourceFeature& feature) const {
    for (const std::size_t column : columns_[layer]) {
      const auto* text = std::get_if<std::string>(&feature.values[column]);
      if (text == nullptr || text->empty()) continue;
      const auto& name = layers()[layer].fields[column];
      if (!STARTS_WITH_CI(name.c_str(), "WKT") && !looks_like_a_shape(*text)) continue;
      if (read_extended(*text, sagitta_m, feature)) return;
      feature.broken = "its " + name + " cannot be read: '" + text->substr(0, kQuoted) +
                       (text->size() > kQuoted ? " …'" : "'");
      return;
    }
  }

  // "SRID=25831;POLYGON(…" of PostGIS.
  static bool read_extended(const std::string& text, double sagitta_m, SourceFeature& feature) {
    const auto end = text.find(';');
    if (!STARTS_WITH_CI(text.c_str(), "SRID=") || end == text.npos) return false;
    const GdalMessages quiet;
    OGRGeometry* geometry = nullptr;
    const auto error =
        OGRGeometryFactory::createFromWkt(text.c_str() + end + 1, nullptr, &geometry);
    const std::unique_ptr<OGRGeometry> owner(geometry);
    if (error != OGRERR_NONE || geometry == nullptr) return false;
    append_paths(geometry, sagitta_m, feature.geometry);
    return true;
  }

  std::string path_;
  std::vector<std::vector<std::size_t>> columns_;  // by layer: those of shapes
};

// A table that is a single column of shapes has no separator that would tell GDAL that it is one.
bool is_single_column(const std::string& content) {
  std::string name = content.substr(0, content.find_first_of("\r\n"));
  if (name.starts_with("\xef\xbb\xbf")) name.erase(0, 3);
  std::erase(name, '"');
  return is_shape_column(name);
}

// Begins a second column in the header of a copy in memory. Tabs separate, because well-known text
// need not be in quotes where nothing else could be meant by its commas.
Result<GdalInput> with_second_column(const GdalInput& input, std::string content) {
  content.insert(std::min(content.find_first_of("\r\n"), content.size()), "\t");
  GdalInput copy = input;
  copy.path = "/vsimem/single_column/" + std::filesystem::path(input.path).filename().string();
  auto* file = VSIFOpenL(copy.path.c_str(), "wb");
  const bool complete =
      file != nullptr && VSIFWriteL(content.data(), 1, content.size(), file) == content.size();
  if (file != nullptr) VSIFCloseL(file);
  if (complete) return copy;
  return input_failure(input.title + ": there is no memory for a copy of it");
}

constexpr std::size_t kLongestHeader = 64;

// What GDAL can read as a table.
Result<GdalInput> readable_table(const GdalInput& input) {
  std::string start(kLongestHeader, '\0');
  start.resize(StoredFile(input.path).read(0, start.data(), start.size()));
  if (!is_single_column(start)) return input;
  auto content = stored_content(input.path);
  return content ? with_second_column(input, *std::move(content)) : Result<GdalInput>(input);
}

}  // namespace

bool is_csv(const std::string& path) {
  return EQUAL(std::filesystem::path(path).extension().c_str(), ".csv");
}

OpenedReader open_csv(const GdalInput& input, const DriverNotice& notice) {
  const auto readable = readable_table(input);
  if (!readable) return tl::unexpected(readable.error());
  auto table = open_gdal(*readable, notice);
  if (!table || (*table)->driver() != "CSV") return table;
  return std::make_unique<CsvReader>(input.title, input.path, *std::move(table));
}

}  // namespace mapwright::converter
