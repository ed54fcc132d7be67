#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "converter/exporters/field.hpp"
#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;

std::string corridor() {
  return project_file("tests/fixtures/checks/N107.txt").string();
}

TEST(LocalizabilityVerb, AnswersByTheContract) {
  const ProgramRun run =
      test::run({"localizability", corridor(), "--cell", "1", "--no-twins", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json answer = Json::parse(run.out);
  EXPECT_EQ(answer.begin().key(), "schema");
  EXPECT_EQ(answer["schema"], "mapwright.localizability/1");
  EXPECT_EQ(answer["grid"]["columns"], 60);
  EXPECT_EQ(answer["places"], 180);
  EXPECT_TRUE(answer["position_sd_m"]["worst_heading"]["p95"].is_null());
  EXPECT_TRUE(answer["alias_risk"].is_null());
  ASSERT_EQ(answer["areas"].size(), 1U);
  const Json& area = answer["areas"][0];
  EXPECT_EQ(area["kind"], "inaccurate");
  EXPECT_TRUE(area["accuracy_m"].is_null());
  EXPECT_NEAR(area["direction_deg"].get<double>(), 0.0, 1e-6);
  // The corridor is 60 m long and the laser sees 15 m.
  EXPECT_NEAR(area["area_m2"].get<double>(), 90.0, 6.0);
  EXPECT_FALSE(answer.contains("confirmation"));
}

TEST(LocalizabilityVerb, SaysUnknownWhereNothingIsSeen) {
  const ProgramRun run = test::run(
      {"localizability", corridor(), "--cell", "1", "--no-twins", "--laser-height", "100"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("heading, median heading: unknown (median), unknown (95 %)"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(run.out.find("inf"), std::string::npos) << run.out;
}

TEST(LocalizabilityVerb, WritesNamedBandsWithNoDataInSolids) {
  TemporaryFolder folder;
  const std::string sample = project_file("samples/campus/campus.txt").string();
  const std::string path = folder.path("field.tif");
  const ProgramRun run = test::run({"localizability", sample, "-o", path, "--cell", "2",
                                    "--no-twins", "--bbox", "0,40,60,90", "--quiet"});
  ASSERT_EQ(run.status, 0) << run.err;
  GDALAllRegister();
  GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(dataset);
  EXPECT_EQ(dataset->GetRasterXSize(), 30);
  EXPECT_EQ(dataset->GetRasterYSize(), 25);
  ASSERT_EQ(dataset->GetRasterCount(), 8);
  auto* band = dataset->GetRasterBand(1);
  EXPECT_STREQ(band->GetDescription(), "position_sd_major_m");
  EXPECT_EQ(band->GetNoDataValue(nullptr), -9999.0);
  ASSERT_NE(dataset->GetSpatialRef(), nullptr);
  const auto value = [&](int column, int row) {
    float v = 0.0F;
    EXPECT_EQ(band->RasterIO(GF_Read, column, row, 1, 1, &v, 1, 1, GDT_Float32, 0, 0, nullptr),
              CE_None);
    return v;
  };
  EXPECT_EQ(value(6, 10), -9999.0F);  // (13, 69), in the building
  EXPECT_GT(value(12, 10), 0.0F);     // (25, 69), in its court
  EXPECT_LT(value(12, 10), 0.05F);
}

TEST(LocalizabilityVerb, WritesCellsAndWeakAreas) {
  TemporaryFolder folder;
  const std::string path = folder.path("field.gpkg");
  const ProgramRun run =
      test::run({"localizability", corridor(), "-o", path, "--cell", "1", "--no-twins"});
  ASSERT_EQ(run.status, 0) << run.err;
  GDALAllRegister();
  GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(dataset);
  auto* cells = dataset->GetLayerByName("cells");
  ASSERT_NE(cells, nullptr);
  EXPECT_EQ(cells->GetFeatureCount(), 180);
  auto* areas = dataset->GetLayerByName("weak_areas");
  ASSERT_NE(areas, nullptr);
  ASSERT_EQ(areas->GetFeatureCount(), 1);
  const OGRFeatureUniquePtr area(areas->GetNextFeature());
  EXPECT_STREQ(area->GetFieldAsString("kind"), "inaccurate");
  EXPECT_NEAR(area->GetGeometryRef()->toPolygon()->get_Area(), area->GetFieldAsDouble("area_m2"),
              1e-6);
}

TEST(LocalizabilityVerb, FiltersSeeWhatIsPredicted) {
  TemporaryFolder folder;
  const std::string path = folder.path("seen.png");
  const ProgramRun run =
      test::run({"localizability", project_file("samples/campus/campus.txt").string(), "-o", path,
                 "--bbox", "20,60,32,72", "--cell", "2", "--no-twins", "--confirm", "6",
                 "--confirm-runs", "12", "--format", "json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(std::filesystem::file_size(path), 1000U);
  const Json seen = Json::parse(run.out)["confirmation"]["seen_to_bound"];
  EXPECT_GT(seen["minor"]["median"], 0.7);
  EXPECT_LT(seen["minor"]["median"], 1.4);
  EXPECT_LT(seen["heading"]["median"], 1.5);
}

TEST(LocalizabilityVerb, RefusesWhatMakesNoSense) {
  EXPECT_EQ(test::run({"localizability", corridor(), "-o", "x.jpg"}).status, 2);
  EXPECT_EQ(test::run({"localizability", corridor(), "--at", "best"}).status, 2);
  EXPECT_EQ(test::run({"localizability", corridor(), "--show", "risk", "--no-twins"}).status, 2);
  EXPECT_EQ(test::run({"localizability", corridor(), "--cell", "0.0001"}).status, 2);
  EXPECT_EQ(test::run({"localizability", "missing.txt"}).status, 3);
  for (const std::vector<std::string>& nowhere : {std::vector<std::string>{"--cell", "1000"},
                                                  {"--cell", "1", "--bbox", "500,500,600,600"},
                                                  {"--cell", "1", "--robot-radius", "100"}}) {
    std::vector<std::string> arguments{"localizability", corridor(), "--no-twins"};
    arguments.insert(arguments.end(), nowhere.begin(), nowhere.end());
    const ProgramRun run = test::run(arguments);
    EXPECT_EQ(run.status, 2) << nowhere[0];
    EXPECT_NE(run.err.find("there is no place to look at"), std::string::npos) << run.err;
  }
  EXPECT_EQ(
      test::run({"localizability", corridor(), "--cell", "1", "--no-twins", "-o", "missing/x.png"})
          .status,
      4);
}

// A ring of cells around a hole, and a cell that touches it with a corner only.
TEST(CellPolygons, HaveHolesAndNoPinches) {
  converter::Field field;
  field.columns = 5;
  field.rows = 4;
  const auto polygons = converter::cell_polygons(field, {0, 1, 2, 5, 7, 10, 11, 12, 18});
  ASSERT_EQ(polygons.size(), 2U);
  ASSERT_EQ(polygons[0].size(), 2U);
  EXPECT_EQ(polygons[0][0].size(), 4U);
  EXPECT_EQ(signed_area_m2(polygons[0][0]), 9.0);
  EXPECT_EQ(signed_area_m2(polygons[0][1]), -1.0);
  ASSERT_EQ(polygons[1].size(), 1U);
  EXPECT_EQ(signed_area_m2(polygons[1][0]), 1.0);
}

}  // namespace
}  // namespace mapwright
