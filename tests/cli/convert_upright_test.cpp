// `mapwright convert` on polygons that stand upright in space.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;

class UprightFaces : public testing::Test {
 protected:
  // The obstacles of one shape in space; `height` as the table has it.
  std::vector<Obstacle> made_of(const std::string& wkt, const std::string& height = "",
                                const std::vector<std::string>& more = {}) {
    const auto table = folder_.file("a.csv", "height,WKT\n" + height + ",\"" + wkt + "\"\n");
    std::vector<std::string> arguments{"convert",
                                       table,
                                       "--local",
                                       "-o",
                                       folder_.path("map.txt"),
                                       "--report",
                                       folder_.path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto made = test::run(arguments);
    EXPECT_EQ(made.status, 0) << made.err;
    if (made.status != 0) return {};
    return read_map(content(folder_.path("map.txt"))).map.obstacles;
  }
  json feature() const { return json::parse(content(folder_.path("r.json")))["features"][0]; }

  test::TemporaryFolder folder_;
};

constexpr const char* kUprightFace = "POLYGON Z((0 0 5,8 1 5,8 1 8,0 0 8,0 0 5))";

TEST_F(UprightFaces, AreAsHighAsAFieldSaysElseAsTheyStand) {
  const auto height = [&](const std::string& field, const std::vector<std::string>& more = {}) {
    const auto walls = made_of(kUprightFace, field, more);
    EXPECT_EQ(walls.size(), 1U);
    return walls.empty() ? 0.0 : walls[0].segments[0].height_m;
  };
  EXPECT_DOUBLE_EQ(height(""), 3.0);
  EXPECT_DOUBLE_EQ(height("2.25"), 2.25);
  const auto fixed = folder_.file(
      "r.yaml", "mapwright_rules: 1\nrules:\n  - {name: w, kind: wall, height: 1.5}\n");
  EXPECT_DOUBLE_EQ(height("", {"--rules", fixed}), 1.5) << "a rule that states one number means it";
  const auto fallback = folder_.file(
      "r.yaml", "mapwright_rules: 1\nrules:\n  - {name: w, kind: wall, height: [height, 1.5]}\n");
  EXPECT_DOUBLE_EQ(height("", {"--rules", fallback}), 3.0);
}

TEST_F(UprightFaces, OverSlopingGroundAreNoHigherThanTheyStandAnywhere) {
  const auto walls = made_of("POLYGON Z((0 0 0,8 0 2,8 0 5,0 0 3,0 0 0))");
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_DOUBLE_EQ(walls[0].segments[0].height_m, 3.0);
}

TEST_F(UprightFaces, MayBeBent) {
  const auto walls = made_of("POLYGON Z((0 0 0,5 1 0,10 0 0,10 0 2,5 1 2,0 0 2,0 0 0))");
  ASSERT_EQ(walls.size(), 1U);
  ASSERT_EQ(walls[0].segments.size(), 2U);
  EXPECT_EQ(walls[0].segments[0].b, (Point{5, 1}));
  EXPECT_DOUBLE_EQ(walls[0].segments[1].height_m, 2.0);
}

TEST_F(UprightFaces, OfTwoTrianglesAreOneWall) {
  const auto walls =
      made_of("POLYHEDRALSURFACE Z(((0 0 0,8 1 0,8 1 3,0 0 0)),((0 0 0,8 1 3,0 0 3,0 0 0)))");
  EXPECT_EQ(walls.size(), 1U);
}

TEST_F(UprightFaces, OnTheOutlineOfTheirGroundAddNothing) {
  const std::string floor = "((0 0 0,8 0 0,8 6 0,0 6 0,0 0 0))";
  const std::string facade = "((2 0 0,6 0 0,6 0 3,2 0 3,2 0 0))";
  const std::string fence = "((8 0 0,12 5 0,12 5 1,8 0 1,8 0 0))";
  EXPECT_EQ(made_of("MULTIPOLYGON Z(" + floor + "," + facade + ")").size(), 1U);
  EXPECT_NE(feature()["reasons"][0]["message"].get<std::string>().find("adds nothing"),
            std::string::npos);
  EXPECT_EQ(made_of("MULTIPOLYGON Z(" + floor + "," + facade + "," + fence + ")").size(), 2U);
}

TEST_F(UprightFaces, LoseTheirOpeningsNotInSilence) {
  EXPECT_EQ(
      made_of("POLYGON Z((0 0 0,8 0 0,8 0 3,0 0 3,0 0 0),(2 0 0,3 0 0,3 0 2,2 0 2,2 0 0))").size(),
      1U);
  EXPECT_EQ(feature()["outcome"], "changed");
}

TEST_F(UprightFaces, LoseDoorwaysThatAreCutOutOfThemNotInSilence) {
  const auto outcome = [&](const std::string& ring) {
    EXPECT_EQ(made_of("POLYGON Z((" + ring + "))").size(), 1U);
    return feature()["outcome"].get<std::string>();
  };
  EXPECT_EQ(outcome("0 0 0,3 0 0,3 0 2,4 0 2,4 0 0,8 0 0,8 0 3,0 0 3,0 0 0"), "changed");
  EXPECT_NE(feature().dump().find("openings of an upright face are closed"), std::string::npos);
  EXPECT_EQ(outcome("0 0 0,8 0 0,8 0 2,4 0 2,4 0 4,0 0 4,0 0 0"), "written") << "a top that steps";
  EXPECT_EQ(outcome("0 0 0,4 0 0,4 0 0.2,8 0 0.2,8 0 3,0 0 3,0 0 0"), "written") << "a kerb";
  EXPECT_EQ(outcome("0 0 0,8 0 4,8 0 7,0 0 3,0 0 0"), "written") << "a slope";
}

// A line over hilly ground, one that a surveyor walked back, a sliver on a slope.
TEST_F(UprightFaces, AreNotSeenWhereTheGroundIsHilly) {
  const auto fence = made_of("LINESTRING Z(0 0 0,5 0 3,10 0 1)");
  ASSERT_EQ(fence.size(), 1U);
  EXPECT_EQ(fence[0].segments.size(), 2U);
  EXPECT_DOUBLE_EQ(fence[0].segments[0].height_m, 1.0);
  const auto walked = made_of("LINESTRING Z(0 0 0,5 0 0,0 0 0.06)");
  ASSERT_EQ(walked.size(), 1U);
  EXPECT_DOUBLE_EQ(walked[0].segments[0].height_m, 1.0);
  const auto roof = made_of("POLYGON Z((0 0 5,8 0 5,8 4 8,0 4 8,0 0 5))");
  ASSERT_EQ(roof.size(), 1U);
  EXPECT_EQ(roof[0].segments.size(), 4U);
}

}  // namespace
}  // namespace mapwright
