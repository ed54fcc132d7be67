#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;

class ClearanceVerb : public testing::Test {
 protected:
  // Two rooms, a door of 0.8 m, a bench in the smaller one.
  ClearanceVerb() {
    Map site = map({0, 10, 20, 0},
                   {box(1, 11.9, 0, 12.1, 4), box(2, 11.9, 4.8, 12.1, 10), box(3, 15, 1, 17, 1.5)});
    site.obstacles[2].semantic = "bench,name=East bench";
    map_ = folder_.file("site.txt", format_map(site));
  }
  ProgramRun clearance(std::vector<std::string> options) const {
    options.insert(options.begin(), {"clearance", map_});
    return run(options);
  }

  TemporaryFolder folder_;
  std::string map_;
};

TEST_F(ClearanceVerb, AnswersByTheContract) {
  const ProgramRun run = clearance({"--radii", "0.41,0,0.4", "--format", "json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const Json answer = Json::parse(run.out);
  EXPECT_EQ(answer.begin().key(), "schema");
  EXPECT_EQ(answer["schema"], "mapwright.clearance/1");
  EXPECT_EQ(answer["places"], 1);
  const Json& rows = answer["rows"];
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["radius_m"], 0.0);
  EXPECT_NEAR(rows[0]["free_area_m2"], 200.0 - 0.2 * 9.2 - 1.0, 1e-6);
  EXPECT_EQ(rows[0]["share"], 1.0);
  EXPECT_EQ(rows[1]["components"], 1);  // a door as wide as the robot lets it pass
  EXPECT_EQ(rows[1]["places_lost"], Json::array());
  EXPECT_EQ(rows[2]["components"], 2);
  EXPECT_LT(rows[2]["share"], 0.65);
  EXPECT_EQ(rows[2]["places_lost"], Json::array({"East bench"}));
}

TEST_F(ClearanceVerb, TextHasALineForEachRadius) {
  const ProgramRun run = clearance({"--radii", "0.3,0.5"});
  EXPECT_NE(run.out.find("   0.300 "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(" 0  without East bench\n"), std::string::npos) << run.out;
}

TEST_F(ClearanceVerb, WrongUsageAndBadMaps) {
  EXPECT_EQ(clearance({"--radii", "-1"}).status, 2);
  EXPECT_EQ(clearance({"--radii", "nan"}).status, 2);
  EXPECT_EQ(clearance({"--radii", ""}).status, 2);
  EXPECT_EQ(clearance({"--ramps", "force"}).status, 2);
  EXPECT_EQ(clearance({"--format", "xml"}).status, 2);
  map_ = folder_.path("none.txt");
  EXPECT_EQ(clearance({}).status, 3);
  map_ = folder_.file("no_border.txt", format_map(map({10, 0, 0, 10}, {})));
  const ProgramRun run = clearance({});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("border"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace mapwright
