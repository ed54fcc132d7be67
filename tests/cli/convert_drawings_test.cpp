// `mapwright convert` on DXF drawings: what GDAL reads of them, and what it passes over.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::content;
using test::TemporaryFolder;

class Drawings : public testing::Test {
 protected:
  test::ProgramRun convert(const std::string& text, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{
        "convert",  folder_.file("a.dxf", text), "--local", "-o", folder_.path("map.txt"),
        "--report", folder_.path("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::run(arguments);
  }
  Map map() const { return read_map(content(folder_.path("map.txt"))).map; }

  TemporaryFolder folder_;
};

// A drawing of a wall, of what `entities` says, and of the blocks it inserts.
std::string drawing_with(const std::string& entities, const std::string& blocks = "") {
  return "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks +
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nLINE\n8\nWALLS\n10\n0\n20\n0\n11\n5\n21\n0\n0\nENDSEC\n0\nEOF\n";
}

std::string insertion(const std::string& block) {
  return "0\nINSERT\n8\nWALLS\n2\n" + block + "\n10\n2\n20\n2\n";
}

std::string block_of(const std::string& name, const std::string& entities,
                     const std::string& flags = "0") {
  return "0\nBLOCK\n8\n0\n2\n" + name + "\n70\n" + flags + "\n10\n0\n20\n0\n" + entities +
         "0\nENDBLK\n";
}

// GDAL passes over entities that it does not know, and says nothing.
TEST_F(Drawings, EntitiesOfDrawingsThatCannotBeReadAreLost) {
  const std::string solid = "0\n3DSOLID\n8\nWALLS\n70\n1\n1\nx\n";
  const std::string mline = "0\nMLINE\n8\nWALLS\n2\nSTANDARD\n";
  const std::string column = block_of("COLUMN", "0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n0.3\n");
  const auto lost = [&](const std::string& text, const std::string& why) {
    const auto refused = convert(text);
    EXPECT_EQ(refused.status, 3) << refused.err;
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
    EXPECT_EQ(json::parse(content(folder_.path("r.json")))["totals"],
              json::parse(R"({"features":2,"written":1,"changed":0,"dropped":1})"));
    EXPECT_EQ(convert(text, {"--skip-broken"}).status, 1);
  };
  lost(drawing_with(solid), "a 3DSOLID cannot be read: explode it");
  lost(drawing_with(mline), "GDAL finds no shape in it");
  lost(drawing_with(insertion("DOOR"), column), "the block 'DOOR' that it inserts is not in");
  lost(drawing_with(insertion("PLAN"), block_of("PLAN", "", "4")), "bind external references");
  EXPECT_EQ(convert(drawing_with(insertion("COLUMN"), column)).status, 0);
  EXPECT_EQ(map().obstacles.size(), 2U);
}

TEST_F(Drawings, EntitiesInBlocksAreLostToo) {
  const auto nested = block_of("OUTER", insertion("INNER")) +
                      block_of("INNER", "0\nACAD_PROXY_ENTITY\n8\n0\n90\n498\n");
  const auto refused = convert(drawing_with(insertion("OUTER"), nested));
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("in the block 'OUTER' in the block 'INNER' a ACAD_PROXY_ENTITY"),
            std::string::npos)
      << refused.err;
}

TEST_F(Drawings, EntitiesThatShowNothingSolidAreNamed) {
  const auto made = convert(drawing_with("0\nRAY\n8\nWALLS\n10\n0\n20\n0\n11\n1\n21\n0\n"));
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("passed over, for it stands for nothing solid: 1 RAY"), std::string::npos)
      << made.err;
  const auto ignored = convert(drawing_with("0\n3DSOLID\n8\nDIMENSIONS\n70\n1\n"));
  EXPECT_EQ(ignored.status, 0) << ignored.err;
}

using Corners = std::vector<std::array<double, 3>>;

std::string group(int code, double value) {
  return std::to_string(code) + "\n" + std::to_string(value) + "\n";
}

std::string face_3d(const Corners& corners) {
  std::string text = "0\n3DFACE\n8\nWALLS\n";
  for (int i = 0; i < 4; ++i) {
    const auto& corner = corners[std::min<std::size_t>(i, corners.size() - 1)];
    text += group(10 + i, corner[0]) + group(20 + i, corner[1]) + group(30 + i, corner[2]);
  }
  return text;
}

std::string polyline_3d(const Corners& corners) {
  std::string text = "0\nPOLYLINE\n8\nWALLS\n66\n1\n70\n9\n";
  for (const auto& corner : corners) {
    text += "0\nVERTEX\n8\nWALLS\n" + group(10, corner[0]) + group(20, corner[1]) +
            group(30, corner[2]) + "70\n32\n";
  }
  return text + "0\nSEQEND\n8\nWALLS\n";
}

const Corners kUpright{{0, 7, 1}, {4, 10, 1}, {4, 10, 3.5}, {0, 7, 3.5}};

// The wall of what `entities` says stands before the drawing's own.
void expect_upright_wall(const Map& map, Point a, Point b, double height_m) {
  ASSERT_EQ(map.obstacles.size(), 2U);
  const auto& wall = map.obstacles[0];
  EXPECT_EQ(wall.shape_type, ShapeType::kOpenPolygon);
  ASSERT_EQ(wall.segments.size(), 1U);
  EXPECT_EQ(wall.segments[0].a, a);
  EXPECT_EQ(wall.segments[0].b, b);
  EXPECT_DOUBLE_EQ(wall.segments[0].height_m, height_m);
}

TEST_F(Drawings, UprightFacesAreWallsAsHighAsTheyStand) {
  const std::string upright[] = {face_3d(kUpright), polyline_3d(kUpright)};
  for (const auto& entity : upright) {
    const auto made = convert(drawing_with(entity));
    ASSERT_EQ(made.status, 0) << made.err;
    expect_upright_wall(map(), {0, 7}, {4, 10}, 2.5);
    const auto feature = json::parse(content(folder_.path("r.json")))["features"][0];
    EXPECT_EQ(feature["outcome"], "written") << feature;
    EXPECT_EQ(feature["reasons"][0]["code"], "C232") << feature;
    EXPECT_EQ(feature["reasons"][0]["message"],
              "a face stands upright: a wall along its footprint, 2.5 m high");
  }
  // A gable, whose top lies over the middle of its foot.
  ASSERT_EQ(convert(drawing_with(face_3d({{0, 7, 0}, {4, 10, 0}, {2, 8.5, 2}}))).status, 0);
  expect_upright_wall(map(), {0, 7}, {4, 10}, 2.0);
}

TEST_F(Drawings, HeightsOfUprightFacesAreInTheUnitOfTheDrawing) {
  Corners in_mm = kUpright;
  for (auto& corner : in_mm) {
    for (auto& number : corner) number *= 1000.0;
  }
  ASSERT_EQ(convert(drawing_with(face_3d(in_mm)), {"--local-unit", "0.001"}).status, 0);
  const auto wall = map().obstacles.front();
  EXPECT_EQ(wall.segments[0].b, (Point{4, 10}));
  EXPECT_DOUBLE_EQ(wall.segments[0].height_m, 2.5);
}

// A mesh of two walls, and the same with a floor under it that has one of them at its edge.
TEST_F(Drawings, FacesOfMeshesThatCoverNoGroundAreWalls) {
  const Corners corners{{0, 7, 0}, {5, 7, 0},  {5, 12, 0}, {0, 12, 0}, {0, 7, 3},
                        {5, 7, 3}, {9, 12, 0}, {9, 12, 3}, {5, 12, 3}};
  const auto mesh = [&](const std::vector<std::array<int, 4>>& faces) {
    std::string text =
        "0\nPOLYLINE\n8\nWALLS\n66\n1\n70\n64\n71\n9\n72\n" + std::to_string(faces.size()) + "\n";
    for (const auto& corner : corners) {
      text += "0\nVERTEX\n8\nWALLS\n100\nAcDbVertex\n100\nAcDbPolyFaceMeshVertex\n" +
              group(10, corner[0]) + group(20, corner[1]) + group(30, corner[2]) + "70\n192\n";
    }
    for (const auto& face : faces) {
      text += "0\nVERTEX\n8\nWALLS\n100\nAcDbFaceRecord\n10\n0\n20\n0\n30\n0\n70\n128\n";
      for (int i = 0; i < 4; ++i) {
        text += std::to_string(71 + i) + "\n" + std::to_string(face[i]) + "\n";
      }
    }
    return text + "0\nSEQEND\n8\nWALLS\n";
  };
  const std::array<int, 4> south{1, 2, 6, 5}, floor{1, 2, 3, 4}, wing{3, 7, 8, 9};
  ASSERT_EQ(convert(drawing_with(mesh({south, wing}))).status, 0);
  ASSERT_EQ(map().obstacles.size(), 3U) << "two walls and the drawing's own";
  EXPECT_DOUBLE_EQ(map().obstacles[0].segments[0].height_m, 3.0);
  ASSERT_EQ(convert(drawing_with(mesh({south, floor}))).status, 0);
  ASSERT_EQ(map().obstacles.size(), 2U) << "the wall is the floor's edge";
  ASSERT_EQ(convert(drawing_with(mesh({south, floor, wing}))).status, 0);
  EXPECT_EQ(map().obstacles.size(), 3U) << "the wing stands beside the floor";
}

}  // namespace
}  // namespace mapwright
