// `mapwright convert` on small drawings made here: what becomes of each kind of feature.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;
using test::GisFeature;
using test::GisLayer;
using test::run;
using test::TemporaryFolder;

struct Converted {
  test::ProgramRun run;
  Map map;
  json report;
};

// Converts layers in plain metres.
Converted convert(const TemporaryFolder& folder, const std::vector<GisLayer>& layers,
                  const std::string& rules = "", std::vector<std::string> more = {}) {
  test::write_gis(folder.path("site.gpkg"), "GPKG", layers);
  std::vector<std::string> arguments{
      "convert",  folder.path("site.gpkg"),  "--local", "-o", folder.path("map.txt"),
      "--report", folder.path("report.json")};
  if (!rules.empty()) {
    arguments.push_back("--rules");
    arguments.push_back(folder.file("rules.yaml", "mapwright_rules: 1\nrules:\n" + rules));
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  Converted converted{run(arguments), {}, {}};
  if (std::filesystem::exists(folder.path("map.txt"))) {
    converted.map = read_map(content(folder.path("map.txt"))).map;
  }
  if (std::filesystem::exists(folder.path("report.json"))) {
    converted.report = json::parse(content(folder.path("report.json")));
  }
  return converted;
}

GisLayer layer(const std::string& name, const std::vector<GisFeature>& features) {
  return {name, "", features, wkbUnknown};
}

TEST(Convert, OrientsOutlinesAndTiesHolesToThem) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("buildings",
             {{"POLYGON((0 0,0 10,10 10,10 0,0 0),(2 2,4 2,4 4,2 4,2 2))", {{"height", "8"}}},
              {"MULTIPOLYGON(((20 0,22 0,22 2,20 2,20 0)),((30 0,30 2,32 2,30 0)))",
               {{"height", "5"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  ASSERT_EQ(result.map.obstacles.size(), 4U);
  const auto& outer = result.map.obstacles[0];
  const auto& hole = result.map.obstacles[1];
  EXPECT_EQ(ring_orientation(chain_points(outer)), RingOrientation::kCounterClockwise);
  EXPECT_EQ(ring_orientation(chain_points(hole)), RingOrientation::kClockwise);
  EXPECT_EQ(hole.semantic.value("inner_of"), "1");
  EXPECT_EQ(outer.segments[0].height_m, 8.0);
  EXPECT_EQ(ring_orientation(chain_points(result.map.obstacles[3])),
            RingOrientation::kCounterClockwise);
  EXPECT_EQ(result.report["totals"],
            json::parse(R"({"features":2,"written":2,"changed":0,"dropped":0})"));
  EXPECT_EQ(result.report["features"][0]["obstacles"], json::parse("[1,2]"));
  EXPECT_EQ(result.report["features"][0]["fid"], 1);
  EXPECT_EQ(result.map.border, (Border{-1.0, 11.0, 33.0, -1.0}));
}

TEST(Convert, RepairsABowTieAndSaysSo) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder, {layer("obstacles", {{"POLYGON((0 0,2 2,2 0,0 2,0 0))", {{"height", "1"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(result.map.obstacles.size(), 2U);
  EXPECT_EQ(result.report["features"][0]["outcome"], "changed");
  EXPECT_EQ(result.report["features"][0]["reasons"][0]["code"], "C201");
}

TEST(Convert, LeavesABowTieWithNoRepairAndRefusesItWithStrict) {
  const std::vector<GisLayer> layers{
      layer("obstacles", {{"POLYGON((0 0,2 2,2 0,0 2,0 0))", {{"height", "1"}}}})};
  const TemporaryFolder folder;
  const auto strict = convert(folder, layers, "", {"--strict"});
  EXPECT_EQ(strict.run.status, 1);
  EXPECT_TRUE(strict.map.obstacles.empty());
  EXPECT_NE(strict.run.err.find("C201"), std::string::npos);
  std::filesystem::remove(folder.path("site.gpkg"));
  const auto as_drawn = convert(folder, layers, "", {"--no-repair"});
  EXPECT_EQ(as_drawn.run.status, 1);
  EXPECT_EQ(as_drawn.map.obstacles.size(), 1U);
  EXPECT_NE(as_drawn.run.err.find("[G104]"), std::string::npos);
}

TEST(Convert, KeepsTheDrawingDirectionOfWalls) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder, {layer("walls", {{"LINESTRING(0 0,4 0,4 3)", {{"height", "2.5"}}},
                               {"LINESTRING(10 0,10 2,12 2,12 0,10 0)", {{"height", "1"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  ASSERT_EQ(result.map.obstacles.size(), 2U);
  EXPECT_EQ(result.map.obstacles[0].shape_type, ShapeType::kOpenPolygon);
  EXPECT_EQ(chain_points(result.map.obstacles[0]), (std::vector<Point>{{0, 0}, {4, 0}, {4, 3}}));
  const auto& fence = result.map.obstacles[1];
  EXPECT_EQ(fence.shape_type, ShapeType::kOpenPolygon);
  EXPECT_EQ(fence.segments.front().a, fence.segments.back().b);
}

TEST(Convert, TurnsAWallThatFacesTheSolidItLeansOn) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder, {layer("buildings", {{"POLYGON((0 0,10 0,10 10,0 10,0 0))", {{"height", "8"}}}}),
               layer("walls", {{"LINESTRING(8 0,2 0)", {{"height", "2"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(chain_points(result.map.obstacles[1]), (std::vector<Point>{{2, 0}, {8, 0}}));
  EXPECT_EQ(result.report["features"][1]["reasons"][0]["code"], "C228");
}

TEST(Convert, MakesChordsOfCurves) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("walls",
             {{"COMPOUNDCURVE((0 0,10 0),CIRCULARSTRING(10 0,15 5,10 10))", {{"height", "2"}}}}),
       layer("buildings", {{"CURVEPOLYGON(CIRCULARSTRING(20 0,30 0,20 0))", {{"height", "3"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  const auto& circle = result.map.obstacles[0];
  const auto& wall = result.map.obstacles[1];
  EXPECT_EQ(circle.shape_type, ShapeType::kClosedCurve);
  EXPECT_EQ(wall.shape_type, ShapeType::kOpenCurve);
  for (const auto& segment : circle.segments) {
    const double middle = distance(0.5 * (segment.a + segment.b), {25, 0});
    EXPECT_GT(middle, 5.0 - 0.01);
    EXPECT_NEAR(distance(segment.a, {25, 0}), 5.0, 0.001);
  }
}

std::vector<double> heights(const Obstacle& obstacle) {
  std::vector<double> all;
  for (const auto& segment : obstacle.segments) all.push_back(segment.height_m);
  return all;
}

TEST(Convert, BuildsStairsFromStepLinesInAnyOrderAndDirection) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("steps",
             {{"LINESTRING(0 0.6,4 0.6)", {{"stair_id", "7"}, {"step_no", "3"}, {"height", "0.5"}}},
              {"LINESTRING(0 0,4 0)", {{"stair_id", "7"}, {"step_no", "1"}, {"height", "0.16"}}},
              {"LINESTRING(4 0.3,0 0.3)",
               {{"stair_id", "7"}, {"step_no", "2"}, {"height", "0.33"}}}}),
       layer("stairs", {{"POLYGON((0 0,4 0,4 0.9,0 0.9,0 0))",
                         {{"stair_id", "7"}, {"steps", "3"}, {"direction_deg", "0"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  ASSERT_EQ(result.map.obstacles.size(), 1U);
  const auto& stairs = result.map.obstacles[0];
  EXPECT_EQ(stairs.shape_type, ShapeType::kStairs);
  EXPECT_EQ(heights(stairs), (std::vector<double>{0.16, 0.33, 0.5, 0.0}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(stairs.segments[i].a, (Point{0, 0.3 * static_cast<double>(i)}));
    EXPECT_EQ(stairs.segments[i].b, (Point{4, 0.3 * static_cast<double>(i)}));
  }
  EXPECT_EQ(stairs.segments[3].a, (Point{4, 0.9}));
  EXPECT_EQ(stairs.segments[3].b, (Point{0, 0.9}));
  EXPECT_EQ(result.report["features"][2]["reasons"][0]["code"], "C222");
  EXPECT_EQ(result.report["features"][3]["reasons"][0]["code"], "C211");
}

TEST(Convert, LaysStepsAcrossAPolygon) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder, {layer("stairs", {{"POLYGON((0 0,1.2 0,1.2 3,0 3,0 0))",
                                 {{"steps", "4"}, {"direction_deg", "90"}, {"rise", "0.15"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  ASSERT_EQ(result.map.obstacles.size(), 1U);
  const auto& stairs = result.map.obstacles[0];
  EXPECT_EQ(heights(stairs), (std::vector<double>{0.15, 0.3, 0.45, 0.6, 0.0}));
  EXPECT_EQ(stairs.segments[0].a,
            (Point{0, 3}));  // upwards is +x: from the left as seen from below
  EXPECT_EQ(stairs.segments[0].b, (Point{0, 0}));
  EXPECT_EQ(stairs.segments[3].a, (Point{0.9, 3}));
  EXPECT_EQ(stairs.segments[4].a, (Point{1.2, 0}));
  EXPECT_EQ(stairs.segments[4].b, (Point{1.2, 3}));
}

TEST(Convert, LaysStepsAcrossACentreLine) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("ways",
             {{"LINESTRING(0 0,0 0.9)", {{"steps", "3"}, {"incline", "down"}, {"width", "2"}}}})},
      "- {kind: stairs, steps: steps, direction: incline, width: width, rise: 0.2}\n");
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  const auto& stairs = result.map.obstacles.at(0);
  EXPECT_EQ(heights(stairs), (std::vector<double>{0.2, 0.4, 0.6, 0.0}));
  EXPECT_EQ(stairs.segments[0].a, (Point{1, 0.9}));  // upwards is −y
  EXPECT_EQ(stairs.segments[0].b, (Point{-1, 0.9}));
  EXPECT_EQ(stairs.segments[3].a, (Point{-1, 0}));
}

TEST(Convert, WritesStairsThatSayTooLittleAsALowObstacle) {
  const TemporaryFolder folder;
  const auto result =
      convert(folder, {layer("stairs", {{"POLYGON((0 0,1 0,1 3,0 3,0 0))", {{"steps", "4"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(result.map.obstacles.at(0).shape_type, ShapeType::kClosedPolygon);
  EXPECT_EQ(result.map.obstacles[0].segments[0].height_m, 0.17);
  EXPECT_EQ(result.report["features"][0]["reasons"][0]["code"], "C217");
}

TEST(Convert, GivesRampsTheirNormalFromFieldsSlopeOrHeights) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("ramps",
             {{"POLYGON((0 0,0 2,4 2,4 0,0 0))", {{"nx", "-0.6"}, {"ny", "0"}, {"nz", "6"}}},
              {"POLYGON((10 0,14 0,14 2,10 2,10 0))", {{"slope_deg", "5"}, {"aspect_deg", "90"}}},
              {"POLYGON Z((20 0 0,24 0 0.4,24 2 0.4,20 2 0,20 0 0))", {}},
              {"POLYGON((30 0,34 0,34 2,30 2,30 0))", {}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  ASSERT_EQ(result.map.obstacles.size(), 3U);
  for (const auto& ramp : result.map.obstacles) {
    EXPECT_EQ(ramp.shape_type, ShapeType::kRamp);
    EXPECT_EQ(ring_orientation(chain_points(ramp)), RingOrientation::kCounterClockwise);
    EXPECT_EQ(max_height_m(ramp), 0.0);
  }
  EXPECT_NEAR(ramp_normal(result.map.obstacles[0])->x, -0.0995037, 1e-6);
  EXPECT_NEAR(ramp_normal(result.map.obstacles[1])->x, std::sin(5.0 * M_PI / 180.0), 1e-9);
  EXPECT_NEAR(ramp_normal(result.map.obstacles[2])->x, -0.0995037, 1e-6);
  EXPECT_EQ(result.report["features"][3]["reasons"][0]["code"], "C218");
}

TEST(Convert, DropsWhatBeginsAboveTheRobot) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("walls", {{"LINESTRING(0 0,4 0)", {{"height", "3"}, {"base_height", "2.4"}}},
                       {"LINESTRING(0 2,4 2)", {{"height", "3"}, {"base_height", "1.9"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(result.map.obstacles.size(), 1U);
  EXPECT_EQ(result.report["features"][0]["outcome"], "dropped");
  EXPECT_EQ(result.report["features"][0]["reasons"][0]["code"], "C210");
}

TEST(Convert, DrawsBordersRoomsAndRoundThings) {
  const TemporaryFolder folder;
  const auto result = convert(
      folder,
      {layer("limits", {{"POLYGON((-5 -5,45 -5,45 25,-5 25,-5 -5))", {}}}),
       layer("rooms", {{"POLYGON((0 0,20 0,20 10,0 10,0 0),(5 5,6 5,6 6,5 6,5 5))", {}}}),
       layer("trees", {{"POINT(30 5)", {}}})},
      "- {layer: limits, kind: border}\n- {layer: rooms, kind: room, height: 3, in_out: indoor}\n"
      "- {layer: trees, kind: solid, radius: 0.3, height: 4}\n");
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(result.map.border, (Border{-5, 25, 45, -5}));
  ASSERT_EQ(result.map.obstacles.size(), 3U);
  EXPECT_EQ(result.map.obstacles[0].shape_type, ShapeType::kClosedCurve);
  for (const auto& segment : result.map.obstacles[0].segments) {
    EXPECT_GE(distance(segment.a, {30, 5}), 0.299);
    EXPECT_LE(distance(segment.a, {30, 5}), 0.335);
  }
  EXPECT_EQ(ring_orientation(chain_points(result.map.obstacles[1])), RingOrientation::kClockwise);
  EXPECT_EQ(result.map.obstacles[1].segments[0].in_out, InOut::kIndoor);
  EXPECT_EQ(ring_orientation(chain_points(result.map.obstacles[2])),
            RingOrientation::kCounterClockwise);
  EXPECT_EQ(result.map.obstacles[1].semantic.view(), "rooms");
}

TEST(Convert, SelectsByConditionAndBox) {
  const TemporaryFolder folder;
  const auto result = convert(folder,
                              {layer("walls", {{"LINESTRING(0 0,4 0)", {{"height", "3"}}},
                                               {"LINESTRING(0 2,4 2)", {{"height", "1"}}},
                                               {"LINESTRING(90 2,94 2)", {{"height", "3"}}}})},
                              "", {"--where", "height > 2", "--bbox", "-1,-1,50,50"});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  EXPECT_EQ(result.map.obstacles.size(), 1U);
  EXPECT_EQ(result.report["features"][1]["reasons"][0]["code"], "C214");
  EXPECT_EQ(result.report["features"][2]["reasons"][0]["code"], "C213");
}

TEST(Convert, NamesFeaturesWithoutGeometryAndPointsInTheLedger) {
  const TemporaryFolder folder;
  const auto result =
      convert(folder, {layer("things", {{"", {{"name", "none"}}},
                                        {"POLYGON EMPTY", {{"name", "empty"}}},
                                        {"POINT(1 1)", {{"name", "point"}}},
                                        {"LINESTRING(3 3,3 3)", {{"name", "dot"}}},
                                        {"LINESTRING(0 0,4 0)", {{"name", "wall"}}}})});
  ASSERT_EQ(result.run.status, 0) << result.run.err;
  std::vector<std::string> codes;
  for (const auto& feature : result.report["features"]) {
    if (feature["outcome"] == "dropped") codes.push_back(feature["reasons"].back()["code"]);
  }
  EXPECT_EQ(codes, (std::vector<std::string>{"C206", "C206", "C208", "C204"}));
  EXPECT_EQ(result.report["totals"]["features"], 5);
  EXPECT_EQ(result.report["totals"]["written"], 1);
}

TEST(Convert, GivesTheSameBytesForShapefilesAndGeoPackage) {
  const TemporaryFolder folder;
  const std::vector<GisLayer> layers{
      {"walls",
       "EPSG:25831",
       {{"LINESTRING(430000 4580000,430010.123 4580001.5)", {{"height", "2"}, {"name", "nord"}}}},
       wkbLineString},
      {"buildings",
       "EPSG:25831",
       {{"POLYGON((430020 4580000,430030 4580000,430030 4580010,430020 4580000))",
         {{"height", "9"}}}},
       wkbPolygon}};
  test::write_gis(folder.path("a.gpkg"), "GPKG", layers);
  test::write_gis(folder.path("shapes"), "ESRI Shapefile", {layers[1], layers[0]});
  const auto first = run({"convert", folder.path("a.gpkg"), "-o", folder.path("a.txt")});
  const auto second = run({"convert", folder.path("shapes"), "-o", folder.path("b.txt")});
  ASSERT_EQ(first.status, 0) << first.err;
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(content(folder.path("a.txt")), content(folder.path("b.txt")));
  const auto sidecar = parse_georeference(content(folder.path("a.georef.json")));
  ASSERT_TRUE(sidecar.has_value()) << sidecar.error().message;
  EXPECT_EQ(sidecar->sources.at(0).path, "a.gpkg");
  EXPECT_EQ(sidecar->sources.at(0).crs, "EPSG:25831");
  EXPECT_NE(sidecar->wkt2.find("Transverse Mercator"), std::string::npos);
}

TEST(Convert, LeavesSourcesAsTheyAre) {
  const TemporaryFolder folder;
  const std::vector<GisLayer> layers{
      {"walls",
       "EPSG:25831",
       {{"LINESTRING(430000 4580000,430010 4580001)", {{"height", "2"}}}},
       wkbLineString}};
  test::write_gis(folder.path("site.gpkg"), "GPKG", layers);
  test::write_gis(folder.path("walls.shp"), "ESRI Shapefile", layers);
  const auto listing = [&] {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
      if (entry.path().filename().string().find("map.") == 0) continue;
      files[entry.path().filename().string()] = content(entry.path().string());
    }
    return files;
  };
  const auto before = listing();
  EXPECT_EQ(run({"convert", folder.path("site.gpkg"), folder.path("walls.shp"), "-o",
                 folder.path("map.txt")})
                .status,
            0);
  EXPECT_EQ(listing(), before);
}

TEST(Convert, ExplainsItsRules) {
  const TemporaryFolder folder;
  test::write_gis(folder.path("site.gpkg"), "GPKG",
                  {layer("murs", {{"LINESTRING(0 0,4 0)", {{"Alçada", "2"}}}})});
  const auto result = run({"convert", "--explain-rules", "--local", folder.path("site.gpkg")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("rule 'walls and fences' makes wall: the layer's name fits 'murs'"),
            std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("height from Alçada"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace mapwright
