// mapwright import: tables of lines and grids from files to files.
#include <gtest/gtest.h>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright::test {
namespace {

const std::string kYaml =
    "image: floor.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

// A room of 4 x 3 cells with walls around: '#' occupied, '.' free.
std::string pgm() {
  std::string image = "P5\n6 5\n255\n";
  for (const char c : std::string("#######....##....##....#######")) {
    image += c == '#' ? '\0' : '\xFE';
  }
  return image;
}

TEST(Import, LinesBecomeWalls) {
  const TemporaryFolder folder;
  const auto lines = folder.file("lines.csv", "ax,ay,bx,by,support\n0,0,4,0,7\n4,0,4.5,3,9\n");
  const auto result = run({"import", lines, "-o", "-", "--height", "2.5"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Map map = read_map(result.out).map;
  ASSERT_EQ(map.obstacles.size(), 2U);
  EXPECT_EQ(map.obstacles[1].segments[0].b, (Point{4.5, 3.0}));
  EXPECT_EQ(map.obstacles[1].segments[0].height_m, 2.5);
}

TEST(Import, AGridBecomesPolygons) {
  const TemporaryFolder folder;
  folder.file("floor.pgm", pgm());
  const auto yaml = folder.file("floor.yaml", kYaml);
  const auto result = run({"import", yaml, "-o", folder.path("map.txt"), "--simplify", "0"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("2 obstacles"), std::string::npos) << result.err;
  EXPECT_EQ(run({"validate", folder.path("map.txt")}).status, 0);
}

TEST(Import, SaysWhatItCannotRead) {
  const TemporaryFolder folder;
  const auto bad = folder.file("lines.csv", "ax,ay,bx,by\n0,0,1,0\n0,zero,1,1\n");
  const auto result = run({"import", bad, "-o", folder.path("map.txt")});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("lines.csv:3: field 2"), std::string::npos) << result.err;
  const auto yaml = folder.file("floor.yaml", kYaml);  // and no image
  EXPECT_EQ(run({"import", yaml, "-o", folder.path("map.txt")}).status, 3);
  folder.file("floor.pgm", "P2\n1 1\n255\n0\n");
  const auto text_image = run({"import", yaml, "-o", folder.path("map.txt")});
  EXPECT_EQ(text_image.status, 3);
  EXPECT_NE(text_image.err.find("binary"), std::string::npos) << text_image.err;
  EXPECT_EQ(run({"import", folder.file("map.dwg", ""), "-o", folder.path("map.txt")}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path("map.txt")));
}

TEST(Import, WithoutWallsNothingIsWritten) {
  const TemporaryFolder folder;
  const auto none = folder.file("lines.csv", "ax,ay,bx,by\n");
  EXPECT_EQ(run({"import", none, "-o", folder.path("map.txt")}).status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder.path("map.txt")));
}

TEST(Import, RealGridsBecomeValidMaps) {
  MAPWRIGHT_REQUIRE_REAL_DATA("3_robot");
  const TemporaryFolder folder;
  for (const std::string grid :
       {"derived/intel_full", "derived/seattle_full", "derived/freiburg-101_full", "maps_ros/depot",
        "maps_ros/mapserver_test/testmap", "maps_f1tenth/Oschersleben_map"}) {
    const auto source = real_data("3_robot/" + grid + ".yaml").string();
    const auto result = run({"import", source, "-o", folder.path("map.txt")});
    EXPECT_EQ(result.status, 0) << grid << ": " << result.err;
    EXPECT_EQ(result.err.find(": error: "), std::string::npos) << grid << ": " << result.err;
  }
}

}  // namespace
}  // namespace mapwright::test
