// Findings as layers that GIS programs open.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "mapcore/georeference.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;
using test::run;
using test::TemporaryFolder;

// A bow tie, a square that does not close, a fence drawn twice, and a file without end.
constexpr const char* kMap =
    "border;0;20;20;0;#\n"
    "obstacle;1;1;4;bow tie;#\n2;2;6;6;3;1;w;#\n6;6;6;2;3;1;w;#\n6;2;2;6;3;1;w;#\n2;6;2;2;3;1;w;#\n"
    "obstacle;2;1;3;open;#\n10;2;12;2;3;1;w;#\n12;2;12;4;3;1;w;#\n12;4;10;4;3;1;w;#\n"
    "obstacle;3;2;2;fence;#\n2;10;4;10;1;1;w;#\n2;10;4;10;1;1;w;#\n"
    "obstacle;4;1;3;turned;#\n10;10;12;12;1;1;w;#\n12;12;12;10;1;1;w;#\n12;10;10;10;1;1;w;#\n";

Georeference place(double latitude_deg) {
  return {latitude_deg, 2.1134, 120.0, -20.0, {}, "", {}};
}

GDALDatasetUniquePtr opened(const std::string& path) {
  GDALAllRegister();
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
}

std::string wkt_of(const OGRFeature& feature) {
  return feature.GetGeometryRef() == nullptr ? "none" : feature.GetGeometryRef()->exportToWkt();
}

// "G104 1: MULTIPOINT (4 4)" a feature.
std::vector<std::string> rows(OGRLayer* layer) {
  std::vector<std::string> result;
  for (const auto& feature : layer) {
    result.push_back(std::string(feature->GetFieldAsString("code")) + " " +
                     std::to_string(feature->GetFieldAsInteger64("obstacle")) + ": " +
                     wkt_of(*feature));
  }
  return result;
}

TEST(FindingsGeopackage, ShowsTheDefectsThemselves) {
  const TemporaryFolder folder;
  const std::string out = folder.path("findings.gpkg");
  const auto result =
      run({"validate", folder.file("map.txt", kMap), "--format", "gpkg", "-o", out});
  ASSERT_EQ(result.status, 1) << result.err;
  const auto dataset = opened(out);
  ASSERT_TRUE(dataset);
  EXPECT_EQ(rows(dataset->GetLayerByName("findings")),
            (std::vector<std::string>{"G104 1: MULTIPOINT (4 4)", "G105 2: MULTIPOINT (10 2,10 4)",
                                      "G111 3: MULTIPOINT (2 10)", "G107 4: MULTIPOINT (10 10)"}));
  EXPECT_EQ(rows(dataset->GetLayerByName("finding_lines")),
            (std::vector<std::string>{"G104 1: MULTILINESTRING ((2 2,6 6),(6 2,2 6))",
                                      "G105 2: MULTILINESTRING ((10 2,12 2,12 4,10 4))",
                                      "G111 3: MULTILINESTRING ((2 10,4 10),(2 10,4 10))"}));
  EXPECT_EQ(rows(dataset->GetLayerByName("finding_areas")),
            (std::vector<std::string>{"G107 4: MULTIPOLYGON (((12 10,12 12,10 10,12 10)))"}));
}

TEST(FindingsGeopackage, TellsAllThatIsKnown) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string out = folder.path("findings.gpkg");
  run({"validate", map, "--format", "gpkg", "-o", out});
  const auto dataset = opened(out);
  const OGRFeatureUniquePtr feature(dataset->GetLayerByName("findings")->GetNextFeature());
  const auto text = [&](const char* field) {
    return std::string(feature->GetFieldAsString(field));
  };
  EXPECT_EQ(text("map"), map);
  EXPECT_EQ(text("name"), "outline_self_intersection");
  EXPECT_EQ(text("severity"), "error");
  EXPECT_EQ(text("line"), "5");
  EXPECT_EQ(text("column"), "1");
  EXPECT_EQ(text("segment"), "3");
  EXPECT_EQ(text("x"), "4");
  EXPECT_NE(text("message").find("crosses segment 1"), std::string::npos);
  EXPECT_TRUE(feature->IsFieldNull(feature->GetFieldIndex("source")));
}

TEST(FindingsGeopackage, LiesWhereTheSidecarSays) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  folder.file("map.georef.json", format_georeference(place(41.3886)));
  const std::string out = folder.path("findings.gpkg");
  run({"validate", map, "--format", "gpkg", "-o", out});
  const auto dataset = opened(out);
  OGRLayer* const layer = dataset->GetLayerByName("findings");
  EXPECT_EQ(rows(layer).front(), "G104 1: MULTIPOINT (4 4)");
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  ASSERT_NE(layer->GetSpatialRef(), nullptr);
  OGRSpatialReference srs(*layer->GetSpatialRef());
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transform(
      OGRCreateCoordinateTransformation(&srs, &wgs84));
  ASSERT_TRUE(transform);
  double x = 0.0, y = 0.0;
  ASSERT_TRUE(transform->Transform(1, &x, &y));
  EXPECT_NEAR(x, 2.1134, 1e-8);
  EXPECT_NEAR(y, 41.3886, 1e-8);
}

TEST(FindingsGeopackage, OfSeveralFramesIsInDegrees) {
  const TemporaryFolder folder;
  const std::string first = folder.file("a.txt", kMap), second = folder.file("b.txt", kMap);
  const std::string nowhere = folder.file("c.txt", kMap);
  folder.file("a.georef.json", format_georeference(place(41.0)));
  folder.file("b.georef.json", format_georeference(place(42.0)));
  const std::string out = folder.path("findings.gpkg");
  run({"validate", first, second, nowhere, "--format", "gpkg", "-o", out});
  const auto dataset = opened(out);
  OGRLayer* const layer = dataset->GetLayerByName("findings");
  EXPECT_EQ(layer->GetFeatureCount(), 12);
  EXPECT_NEAR(layer->GetFeature(1)->GetGeometryRef()->toMultiPoint()->getGeometryRef(0)->getY(),
              41.0, 1e-3);
  EXPECT_NEAR(layer->GetFeature(5)->GetGeometryRef()->toMultiPoint()->getGeometryRef(0)->getY(),
              42.0, 1e-3);
  EXPECT_EQ(layer->GetFeature(9)->GetGeometryRef(), nullptr);
}

TEST(FindingsGeopackage, IsTheSameEachTime) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  for (const char* name : {"one.gpkg", "two.gpkg"}) {
    run({"validate", map, "--format", "gpkg", "-o", folder.path(name)});
  }
  EXPECT_GT(content(folder.path("one.gpkg")).size(), 4096U);
  EXPECT_EQ(content(folder.path("one.gpkg")), content(folder.path("two.gpkg")));
}

TEST(FindingsGeopackage, NeedsAFile) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  for (const char* verb : {"validate", "check"}) {
    const auto result = run({verb, map, "--format", "gpkg"});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("-o"), std::string::npos);
  }
}

TEST(FindingsGeojson, HasAFeatureForEachKindOfGeometry) {
  const TemporaryFolder folder;
  const auto result = run({"validate", folder.file("map.txt", kMap), "--format", "geojson"});
  const json collection = json::parse(result.out);
  EXPECT_TRUE(collection["crs"].is_null());
  ASSERT_EQ(collection["features"].size(), 8U);
  const json& lines = collection["features"][1];
  EXPECT_EQ(
      lines["geometry"],
      json::parse(R"({"type":"MultiLineString","coordinates":[[[2,2],[6,6]],[[6,2],[2,6]]]})"));
  EXPECT_EQ(lines["properties"]["finding"], 1);
  EXPECT_EQ(lines["properties"]["code"], "G104");
  EXPECT_TRUE(lines["properties"]["source"].is_null());
}

TEST(FindingsGeojson, IsInDegreesWhereThereIsASidecar) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  folder.file("map.georef.json", format_georeference(place(41.3886)));
  const json collection = json::parse(run({"validate", map, "--format", "geojson"}).out);
  EXPECT_FALSE(collection.contains("crs"));
  const json& point = collection["features"][0]["geometry"]["coordinates"][0];
  EXPECT_NEAR(point[0].get<double>(), 2.1134, 1e-3);
  EXPECT_NEAR(point[1].get<double>(), 41.3886, 1e-3);
  EXPECT_EQ(collection["features"][0]["properties"]["x"], 4.0);
}

TEST(FindingsGeojson, OfNoFindingsIsEmpty) {
  const TemporaryFolder folder;
  const auto result =
      run({"validate", folder.file("map.txt", "border;0;9;9;0;#\n"), "--format", "geojson"});
  EXPECT_EQ(json::parse(result.out)["features"], json::array());
}

constexpr const char* kLedger =
    R"({"schema":"mapwright.convert/1","sources":[],"totals":{},"features":[
      {"source":"site.gpkg","layer":"buildings","fid":12,"outcome":"written","obstacles":[1],"reasons":[]},
      {"source":"site.gpkg","layer":"steps","fid":3,"outcome":"written","obstacles":[2],"reasons":[]},
      {"source":"site.gpkg","layer":"steps","fid":4,"outcome":"written","obstacles":[2],"reasons":[]}]})";

TEST(Ledger, NamesLayerAndFeature) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string ledger = folder.file("ledger.json", kLedger);
  const auto text = run({"validate", map, "--ledger", ledger});
  EXPECT_NE(text.out.find("follow (from layer buildings, feature 12 of site.gpkg) [G104]"),
            std::string::npos)
      << text.out;
  const auto report = run({"validate", map, "--ledger", ledger, "--format", "json"});
  const json findings = json::parse(report.out)["maps"][0]["findings"];
  EXPECT_EQ(findings[1]["features"], json::parse(R"([{"source":"site.gpkg","layer":"steps","fid":3},
                            {"source":"site.gpkg","layer":"steps","fid":4}])"));
  EXPECT_FALSE(findings[2].contains("features"));
}

TEST(Ledger, IsRefusedWhereItIsNone) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  EXPECT_EQ(run({"validate", map, "--ledger", map}).status, 3);
  EXPECT_EQ(run({"validate", map, "--ledger", folder.file("x.json", "{\"schema\":1}")}).status, 3);
  EXPECT_EQ(run({"validate", map, "--ledger", folder.path("none.json")}).status, 3);
  EXPECT_EQ(run({"validate", map, map, "--ledger", folder.file("l.json", kLedger)}).status, 2);
}

TEST(Ledger, IsNotNeededWhereTokensNameTheSource) {
  const TemporaryFolder folder;
  const std::string map = folder.file(
      "map.txt",
      "border;0;9;9;0;#\nobstacle;1;2;1;fence,source=fences:old:7;#\n2;2;2;2;3;1;wall;#\n");
  EXPECT_NE(run({"validate", map}).out.find("(from layer fences:old, feature 7) [G103]"),
            std::string::npos);
}

}  // namespace
}  // namespace mapwright
