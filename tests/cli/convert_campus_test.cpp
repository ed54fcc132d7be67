// The report's own site, drawn by one of its authors: shapefiles and GeoPackage.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using test::content;

using nlohmann::json;

test::ProgramRun convert(const std::string& source, const std::string& map,
                         const std::string& report) {
  return test::run({"convert", source, "--origin", "425800,4582230", "--origin-crs", "EPSG:25831",
                    "--heading", "-20", "-o", map, "--report", report});
}

std::size_t count_reasons(const json& report, const std::string& layer, const std::string& code) {
  std::size_t count = 0;
  for (const auto& feature : report["features"]) {
    for (const auto& reason : feature["reasons"]) {
      if (feature["layer"] == layer && reason["code"] == code) ++count;
    }
  }
  return count;
}

TEST(ConvertCampusNord, GivesTheReportsCoordinates) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/shp_25831_latin1");
  const test::TemporaryFolder folder;
  const auto run = convert(test::real_data("campus_nord/shp_25831_latin1").string(),
                           folder.path("map.txt"), folder.path("report.json"));
  ASSERT_EQ(run.status, 0) << run.err;
  const auto map = read_map(content(folder.path("map.txt"))).map;

  std::size_t benches_13 = 0, steps = 0, flights = 0, ramps = 0;
  for (const auto& obstacle : map.obstacles) {
    if (obstacle.shape_type == ShapeType::kClosedPolygon && !obstacle.semantic.value("inner_of")) {
      EXPECT_EQ(ring_orientation(chain_points(obstacle)), RingOrientation::kCounterClockwise);
    }
    const Box box = extent(obstacle);
    if (std::abs(box.min_x - 7.73) < 0.02 && std::abs(box.max_x - 40.66) < 0.02 &&
        std::abs(box.min_y - 4.00) < 0.02 && std::abs(box.max_y - 5.30) < 0.02 &&
        obstacle.semantic.has_label("bench")) {
      ++benches_13;
      EXPECT_EQ(max_height_m(obstacle), 0.5);
    }
    if (obstacle.shape_type == ShapeType::kRamp) ++ramps;
    if (obstacle.shape_type != ShapeType::kStairs) continue;
    ++flights;
    steps += obstacle.segments.size() - 1;
    EXPECT_EQ(obstacle.segments.back().height_m, 0.0);
  }
  EXPECT_EQ(benches_13, 1U);
  EXPECT_EQ(flights, 5U);
  EXPECT_EQ(steps, 38U);
  EXPECT_EQ(ramps, 28U);

  const auto report = json::parse(content(folder.path("report.json")));
  EXPECT_EQ(report["totals"]["features"], 1436 + 90 + 68 + 5 + 38 + 38 + 245);
  EXPECT_EQ(count_reasons(report, "walls", "C210"), 124U);  // overhead
  EXPECT_EQ(count_reasons(report, "ramps", "C208"), 10U);   // roofs
  EXPECT_EQ(count_reasons(report, "ramps", "C225"), 28U);   // normals of the model's own axes
  EXPECT_EQ(count_reasons(report, "ground", "C208"), 245U);
  EXPECT_EQ(count_reasons(report, "stairs", "C211"), 5U);
}

TEST(ConvertCampusNord, IsTheSameMapFromAGeoPackage) {
  MAPWRIGHT_REQUIRE_REAL_DATA("campus_nord/campus_nord_25831.gpkg");
  const test::TemporaryFolder folder;
  ASSERT_EQ(convert(test::real_data("campus_nord/shp_25831_latin1").string(), folder.path("a.txt"),
                    folder.path("a.json"))
                .status,
            0);
  ASSERT_EQ(convert(test::real_data("campus_nord/campus_nord_25831.gpkg").string(),
                    folder.path("b.txt"), folder.path("b.json"))
                .status,
            0);
  EXPECT_EQ(content(folder.path("a.txt")), content(folder.path("b.txt")));
}

}  // namespace
}  // namespace mapwright
