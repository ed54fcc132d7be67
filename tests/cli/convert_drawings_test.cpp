// `mapwright convert` on DXF drawings: what GDAL reads of them, and what it passes over.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mapwright
