// Drawings and OSM tags, from file to map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::run;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Drawing : public testing::Test {
 protected:
  static std::string line(const std::string& layer, double x1, double y1, double x2, double y2) {
    const auto n = [](double value) { return std::to_string(value) + "\n"; };
    return "0\nLINE\n8\n" + layer + "\n10\n" + n(x1) + "20\n" + n(y1) + "11\n" + n(x2) + "21\n" +
           n(y2);
  }
  static std::string dxf(int units, const std::string& entities) {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(units) +
           "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
  }
  // A room of 5 x 3 units times `k`, its walls drawn in any direction, and a door.
  static std::string room(double k) {
    return line("WALLS", 0, 0, 5 * k, 0) + line("WALLS", 5 * k, 3 * k, 5 * k, 0) +
           line("WALLS", 5 * k, 3 * k, 0, 3 * k) + line("DOORS", 0, 3 * k, 0, 0);
  }

  Map convert(const std::string& file, const std::string& content,
              const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"convert", folder_.file(file, content), "-o",
                                       folder_.path("map.txt")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    result_ = run(arguments);
    EXPECT_EQ(result_.status, 0) << result_.err;
    return read_map(text_of(folder_.path("map.txt"))).map;
  }

  test::TemporaryFolder folder_;
  test::ProgramRun result_;
};

double extent_of(const Map& map) {
  double reach = 0.0;
  for (const auto& obstacle : map.obstacles) {
    for (const auto& segment : obstacle.segments) reach = std::max(reach, segment.a.x);
  }
  return reach;
}

TEST_F(Drawing, LayersAreTypesAndLooseLinesBecomeAWall) {
  const auto map = convert("room.dxf", dxf(6, room(1.0)), {"--local"});
  ASSERT_EQ(map.obstacles.size(), 1U) << "the door is a way through";
  EXPECT_EQ(map.obstacles[0].shape_type, ShapeType::kOpenPolygon);
  ASSERT_EQ(map.obstacles[0].segments.size(), 3U);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    EXPECT_EQ(map.obstacles[0].segments[i].b, map.obstacles[0].segments[i + 1].a);
  }
}

TEST_F(Drawing, UnitsOfTheHeaderCount) {
  EXPECT_DOUBLE_EQ(extent_of(convert("mm.dxf", dxf(4, room(1000.0)), {"--local"})), 5.0);
  EXPECT_NEAR(extent_of(convert("ft.dxf", dxf(2, room(10.0)), {"--local"})), 15.24, 1e-9);
}

TEST_F(Drawing, UnitsThatCannotBeAreNotBelieved) {
  EXPECT_DOUBLE_EQ(extent_of(convert("m.dxf", dxf(4, room(1.0)), {"--local"})), 5.0);
  EXPECT_NE(result_.err.find("the unit is not believed"), std::string::npos) << result_.err;
}

class OsmTags : public Drawing {
 protected:
  // A way of 30 m to the north.
  Map convert_way(const std::string& tags) {
    return convert("a.osm",
                   "<osm version='0.6'><node id='1' lat='41.0' lon='2.0'/>"
                   "<node id='2' lat='41.00027012' lon='2.0'/>"
                   "<way id='3'><nd ref='1'/><nd ref='2'/>" +
                       tags + "</way></osm>",
                   {"--origin", "41,2"});
  }
  static std::string tag(const std::string& key, const std::string& value) {
    return "<tag k='" + key + "' v='" + value + "'/>";
  }
};

TEST_F(OsmTags, StepsHaveTheirCountWidthAndDirection) {
  const auto map = convert_way(tag("highway", "steps") + tag("step_count", "10") +
                               tag("incline", "down") + tag("width", "3 m"));
  ASSERT_EQ(map.obstacles.size(), 1U);
  EXPECT_EQ(map.obstacles[0].shape_type, ShapeType::kStairs);
  const auto& segments = map.obstacles[0].segments;
  ASSERT_EQ(segments.size(), 11U);
  EXPECT_NEAR(segments[0].a.y, 30.0, 0.05) << "the foot is in the north";
  EXPECT_NEAR(distance(segments[0].a, segments[0].b), 3.0, 0.01);
  EXPECT_NEAR(segments[9].height_m, 1.7, 1e-9);
  EXPECT_EQ(segments[10].height_m, 0.0);
}

TEST_F(OsmTags, StepsWithoutCountFillTheirLength) {
  const auto map = convert_way(tag("highway", "steps") + tag("incline", "up"));
  ASSERT_EQ(map.obstacles.size(), 1U);
  EXPECT_EQ(map.obstacles[0].segments.size(), 101U);
  EXPECT_NE(result_.err.find("C217"), std::string::npos) << result_.err;
}

TEST_F(OsmTags, StepsWithoutDirectionAreALowWall) {
  const auto map = convert_way(tag("highway", "steps") + tag("step_count", "10"));
  ASSERT_EQ(map.obstacles.size(), 1U);
  EXPECT_EQ(map.obstacles[0].shape_type, ShapeType::kOpenPolygon);
  EXPECT_NEAR(map.obstacles[0].segments[0].height_m, 0.17, 1e-9);
}

TEST_F(OsmTags, WheelchairRampsSlopeAlongTheWay) {
  const auto map = convert_way(tag("highway", "footway") + tag("wheelchair", "yes") +
                               tag("incline", "8%") + tag("width", "2"));
  ASSERT_EQ(map.obstacles.size(), 1U);
  EXPECT_EQ(map.obstacles[0].shape_type, ShapeType::kRamp);
  EXPECT_EQ(map.obstacles[0].segments.size(), 4U);
  const auto normal = ramp_normal(map.obstacles[0]);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(normal->x, 0.0, 1e-3);
  EXPECT_NEAR(normal->y / normal->z, -0.08, 1e-3) << "it rises to the north";
}

TEST_F(OsmTags, BarriersHaveTheirUsualHeights) {
  for (const auto& [barrier, height_m] :
       std::vector<std::pair<std::string, double>>{{"kerb", 0.12},
                                                   {"hedge", 1.5},
                                                   {"wall", 2.0},
                                                   {"guard_rail", 0.8},
                                                   {"city_wall", 4.0}}) {
    const auto map = convert_way(tag("barrier", barrier));
    ASSERT_EQ(map.obstacles.size(), 1U) << barrier;
    EXPECT_EQ(map.obstacles[0].segments[0].height_m, height_m) << barrier;
  }
  EXPECT_EQ(
      convert_way(tag("barrier", "wall") + tag("height", "7 m")).obstacles[0].segments[0].height_m,
      7.0);
}

class Cadastre : public testing::Test {
 protected:
  // Heights of the obstacles, lowest first.
  std::vector<double> heights(const std::string& source, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"convert", test::real_data(source).string(),
                                       "-o",      folder_.path("map.txt"),
                                       "--rules", "cadastre"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    std::vector<double> heights;
    const auto map = read_map(text_of(folder_.path("map.txt"))).map;
    for (const auto& obstacle : map.obstacles) heights.push_back(obstacle.segments[0].height_m);
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Cadastre, ReadsInspireStoreys) {
  MAPWRIGHT_REQUIRE_REAL_DATA("1_gis/catastro/buildingpart.gml");
  const auto all = heights("1_gis/catastro/buildingpart.gml", {});
  ASSERT_EQ(all.size(), 25U);
  EXPECT_EQ(all.front(), 3.0);
  EXPECT_EQ(all.back(), 6.0) << "two storeys";
}

TEST_F(Cadastre, LeavesOutWhatIsNotOnTheGround) {
  MAPWRIGHT_REQUIRE_REAL_DATA("1_gis/bgt_rotterdam/bgt_scheiding.sqlite");
  const auto all =
      heights("1_gis/bgt_rotterdam/bgt_scheiding.sqlite", {"--allow-driver", "SQLite"});
  EXPECT_EQ(all.size(), 53U) << "57 walls, 4 of them on a bridge";
}

}  // namespace
}  // namespace mapwright
