// The verb scan.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

using Json = nlohmann::json;
using test::run;

// A block of 2 m, at x 4 to 6, y −1 to 1, 3 m high, in an empty square.
constexpr const char* kMap = R"(border;
-10;10;
10;-10;
#
obstacle;
7;1;4;block;
#
4;-1;
6;-1;
3;1;wall;
#
6;-1;
6;1;
3;1;wall;
#
6;1;
4;1;
3;1;wall;
#
4;1;
4;-1;
3;1;wall;
#
)";

class Scan : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string map_ = folder_.file("map.txt", kMap);
};

TEST_F(Scan, WarnsOfALaserThatOverlooksTheMap) {
  const auto warning = [&](const std::string& height) {
    return run({"scan", map_, "--pose", "0,0,0", "--laser-height", height}).err;
  };
  EXPECT_EQ(warning("2.999"), "");
  EXPECT_EQ(warning("3"),
            "mapwright: warning: nothing on the map is higher than the laser at 3 m "
            "(--laser-height): its rays meet nothing, and scans tell nothing\n");
}

TEST_F(Scan, AnswersInJson) {
  const auto result = run({"scan", map_, "--pose", "0,0,0", "--rays", "3", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["schema"], "mapwright.scan/1");
  EXPECT_EQ(json["angles_deg"], Json({-90.0, 0.0, 90.0}));
  EXPECT_EQ(json["laser_height"], 0.5);
  EXPECT_EQ(json["max_range"], 15.0);
  ASSERT_EQ(json["scans"].size(), 1U);
  EXPECT_EQ(json["scans"][0]["pose"], Json({{"x", 0.0}, {"y", 0.0}, {"theta_deg", 0.0}}));
  EXPECT_EQ(json["scans"][0]["ranges"], Json({15.0, 4.0, 15.0}));
  EXPECT_EQ(result.out.rfind("{\"schema\"", 0), 0U) << "the schema comes first";
}

TEST_F(Scan, AllEnginesSeeTheSame) {
  for (const char* engine : {"fast", "culled", "brute"}) {
    const auto result = run({"scan", map_, "--pose", "0,0.5,0", "--rays", "5", "--fov", "40",
                             "--engine", engine, "--format", "json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const Json ranges = Json::parse(result.out)["scans"][0]["ranges"];
    EXPECT_EQ(ranges[4], 15.0) << engine;
    EXPECT_NEAR(ranges[1].get<double>(), 4.0 / std::cos(std::numbers::pi / 18.0), 1e-4) << engine;
    EXPECT_NEAR(ranges[2].get<double>(), 4.0, 1e-4) << engine;
  }
}

TEST_F(Scan, RefusesAnUnknownEngine) {
  const auto result = run({"scan", map_, "--pose", "0,0,0", "--engine", "warp"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("fast, culled or brute"), std::string::npos);
}

TEST_F(Scan, FollowsTheLaserOptions) {
  const auto ranges = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"scan", map_, "--pose", "0,0,-90", "--format", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(result.out)["scans"][0]["ranges"];
  };
  EXPECT_EQ(ranges({"--rays", "5", "--fov", "360", "--max-range", "9"}),
            Json({9.0, 9.0, 9.0, 4.0, 9.0}));
  EXPECT_EQ(ranges({"--rays", "2", "--laser-height", "3"}), Json({15.0, 15.0}));
  EXPECT_EQ(ranges({"--rays", "2", "--laser-height", "2.9"}), Json({15.0, 4.0}));
}

TEST_F(Scan, ReadsManyPosesFromATable) {
  const std::string poses = folder_.file("poses.csv", "x,y,theta_deg\n0,0,0\n1,0,0\n\n8,0,180\n");
  const auto result = run({"scan", map_, "--poses", poses, "--rays", "1", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json scans = Json::parse(result.out)["scans"];
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_EQ(scans[0]["ranges"], Json({4.0}));
  EXPECT_EQ(scans[1]["ranges"], Json({3.0}));
  EXPECT_EQ(scans[2]["ranges"], Json({2.0}));
  EXPECT_EQ(scans[2]["pose"]["theta_deg"], 180.0);
}

TEST_F(Scan, SaysWhatASpreadsheetWroteThatIsNoTableOfNumbers) {
  const auto complaint = [&](const std::string& table) {
    const auto result = run({"scan", map_, "--poses", folder_.file("poses.csv", table)});
    EXPECT_EQ(result.status, 3);
    return result.err;
  };
  EXPECT_NE(complaint("x;y;theta_deg\n0;0;0\n").find("separated by commas, not semicolons"),
            std::string::npos);
  EXPECT_NE(complaint("0\t0\t0\n").find("separated by commas, not tabs"), std::string::npos);
  EXPECT_NE(complaint("x,y,theta_deg\n\"0\",0,0\n").find("fields stand without quotes"),
            std::string::npos);
}

TEST_F(Scan, NoiseDependsOnTheSeedAlone) {
  const auto noisy = [&](const std::string& seed) {
    return run({"scan", map_, "--pose", "0,0,0", "--noise", "0.1", "--seed", seed}).out;
  };
  EXPECT_EQ(noisy("3"), noisy("3"));
  EXPECT_NE(noisy("3"), noisy("4"));
}

TEST_F(Scan, RefusesAPoseThatIsNoPlaceForARobot) {
  const auto solid = run({"scan", map_, "--pose", "5,0,0"});
  EXPECT_EQ(solid.status, 2);
  EXPECT_NE(solid.err.find("lies in obstacle 7 (block)"), std::string::npos) << solid.err;
  EXPECT_EQ(solid.out, "");
  const auto outside = run({"scan", map_, "--pose", "11,0,0"});
  EXPECT_EQ(outside.status, 2);
  EXPECT_NE(outside.err.find("border"), std::string::npos) << outside.err;
  const std::string poses = folder_.file("poses.csv", "0,0,0\n5,0,0\n");
  const auto second = run({"scan", map_, "--poses", poses});
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.err.find("pose 2"), std::string::npos) << second.err;
}

TEST_F(Scan, RefusesWrongUsage) {
  const auto status = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments{"scan", map_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments).status;
  };
  EXPECT_EQ(status({}), 2);
  EXPECT_EQ(status({"--pose", "0,0"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--poses", "p.csv"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--rays", "0"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--rays", "-1"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--fov", "361"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--max-range", "0"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--occlusion", "1.5"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--noise", "-1"}), 2);
  EXPECT_EQ(status({"--pose", "0,0,0", "--format", "xml"}), 2);
}

TEST_F(Scan, NamesAnInputThatCannotBeRead) {
  EXPECT_EQ(run({"scan", folder_.path("no.txt"), "--pose", "0,0,0"}).status, 3);
  EXPECT_EQ(run({"scan", map_, "--poses", folder_.path("no.csv")}).status, 3);
  const std::string words = folder_.file("words.csv", "1,2,north\n1,2,x\n");
  EXPECT_EQ(run({"scan", map_, "--poses", words}).status, 3);
}

}  // namespace
}  // namespace mapwright
