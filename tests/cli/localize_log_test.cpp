// mapwright localize --log.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "mapcore/text/reader.hpp"
#include "navcore/engine/scan_engine.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright::test {
namespace {

using Json = nlohmann::json;

// A room of 12 m × 8 m with two things in it.
const std::string kLines =
    "ax,ay,bx,by\n0,0,12,0\n12,0,12,8\n12,8,0,8\n0,8,0,0\n3,3,5,3\n5,3,5,4\n8,5,9,7\n2,6,3,8\n";

constexpr std::size_t kScans = 12;

class LocalizeLog : public testing::Test {
 protected:
  void SetUp() override {
    const auto lines = folder_.file("lines.csv", kLines);
    ASSERT_EQ(run({"import", lines, "-o", map_}).status, 0);
    record();
  }

  // Drives along y = 1.5, a quarter of a metre a scan, looking ahead; the log starts at 0, 0.
  void record() {
    const Map map = read_map(run({"import", folder_.path("lines.csv"), "-o", "-"}).out).map;
    const navcore::ScanEngine engine(map);
    const navcore::LaserModel laser{181, 180.0, 30.0, 0.5};
    std::ostringstream log, table;
    table << "scan,t,odom_x,odom_y,odom_theta,ref_x,ref_y,ref_theta\n";
    for (std::size_t i = 0; i < kScans; ++i) {
      const double x = 2.0 + 0.25 * static_cast<double>(i);
      std::vector<double> ranges(laser.rays);
      engine.cast({x, 1.5, Angle()}, laser, ranges);
      log << "FLASER 181";
      for (const double range : ranges) log << ' ' << range;
      log << " 0 0 0 " << x - 2.0 << " 0 0 " << i << " host " << i << '\n';
      table << i << ',' << i << ',' << x - 2.0 << ",0,0," << x << ",1.5,0\n";
    }
    log_ = folder_.file("run.log", log.str());
    odometry_ = folder_.file("odometry.csv", table.str());
  }

  ProgramRun localize(std::vector<std::string> options) {
    std::vector<std::string> arguments{"localize", map_, "--log", log_};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.path("map.txt");
  std::string log_, odometry_;
};

TEST_F(LocalizeLog, TracksAndComparesWithTheReference) {
  const auto result =
      localize({"--odometry", odometry_, "--initial-pose", "2.1,1.4,3", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["schema"], "mapwright.localize/1");
  EXPECT_EQ(json["converged"], true);
  EXPECT_EQ(json["converged_from_start"], true);
  ASSERT_EQ(json["iterations"].size(), kScans);
  const auto& last = json["iterations"].back();
  EXPECT_EQ(last["n"], kScans);
  EXPECT_EQ(last["scan"], kScans - 1);
  EXPECT_LT(last["position_error_m"].get<double>(), 0.1);
  EXPECT_EQ(last["reference"]["x"], 4.75);
  EXPECT_LT(json["position_error_m"]["median"].get<double>(), 0.1);
}

TEST_F(LocalizeLog, WithoutReferenceItSaysWhatItBelieves) {
  const auto result = localize(
      {"--initial-pose", "2,1.5,0", "--first-scan", "0", "--last-scan", "4", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["iterations"].size(), 5U);
  EXPECT_FALSE(json["iterations"][0].contains("position_error_m"));
  EXPECT_FALSE(json.contains("position_error_m"));
}

TEST_F(LocalizeLog, AnswersManyStretches) {
  const auto windows = folder_.file("windows.csv", "first_scan,last_scan\n0,9\n2,11\n");
  const std::vector<std::string> options{"--odometry", odometry_, "--windows", windows,
                                         "--from-reference"};
  const auto text = localize(options);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("localized 2 of 2, 2 of them from the start"), std::string::npos)
      << text.out;
  auto with_json = options;
  with_json.insert(with_json.end(), {"--format", "json"});
  const Json json = Json::parse(localize(with_json).out);
  EXPECT_EQ(json["trials"], 2);
  EXPECT_EQ(json["converged"], 2);
  EXPECT_EQ(json["runs"][1]["first_scan"], 2);
  const auto many =
      run({"render", map_, "--overlay", folder_.file("many.json", localize(with_json).out), "-o",
           folder_.path("many.svg")});
  EXPECT_EQ(many.status, 3);
  EXPECT_NE(many.err.find("it sums many runs up"), std::string::npos) << many.err;
  with_json.insert(with_json.end(), {"--threads", "1"});
  EXPECT_EQ(Json::parse(localize(with_json).out), json);
}

TEST_F(LocalizeLog, AnswersHowLongItWasLostAfterAKidnapping) {
  const auto windows = folder_.file("windows.csv", "first_scan,last_scan\n0,5\n6,11\n");
  std::vector<std::string> options{"--odometry", odometry_,  "--windows",
                                   windows,      "--kidnap", "--from-reference"};
  const auto text = localize(options);
  EXPECT_NE(text.out.find("right before"), std::string::npos) << text.out;
  options.insert(options.end(), {"--format", "json"});
  const auto answer = localize(options);
  const Json json = Json::parse(answer.out);
  EXPECT_EQ(json["trials"], 2);
  EXPECT_EQ(json["right_before"], 2);
  EXPECT_EQ(json["runs"][0]["before"]["last_scan"], 5);
  EXPECT_EQ(json["runs"][0]["after"]["first_scan"], 6);
  EXPECT_NEAR(json["runs"][0]["carried_m"].get<double>(), 0.25, 1e-9);
  EXPECT_NEAR(json["runs"][1]["carried_m"].get<double>(), 2.75, 1e-9);
  EXPECT_EQ(json["runs"][0]["recovered"], true);  // a quarter of a metre is no loss
  EXPECT_EQ(json["runs"][0]["scans_to_recover"], 1);
  options.insert(options.end(), {"--threads", "1"});
  EXPECT_EQ(localize(options).out, answer.out);
}

TEST_F(LocalizeLog, AnswersTheSameOnAnyNumberOfThreads) {
  const std::vector<std::string> options{"--initial-pose", "2,1.5,0", "--with-particles",
                                         "--format", "json"};
  const auto first = localize(options);
  EXPECT_EQ(first.out, localize(options).out);
  EXPECT_TRUE(Json::parse(first.out)["iterations"][0].contains("particle_set"));
}

TEST_F(LocalizeLog, IsDrawnWithBothWays) {
  const auto answer = localize({"--odometry", odometry_, "--initial-pose", "2,1.5,0",
                                "--with-particles", "--format", "json"});
  const auto overlay = folder_.file("loc.json", answer.out);
  const auto picture = folder_.path("loc.svg");
  ASSERT_EQ(run({"render", map_, "--overlay", overlay, "-o", picture}).status, 0);
  const auto frames =
      run({"render", map_, "--overlay", overlay, "-o", picture, "--iteration", "all"});
  EXPECT_EQ(frames.status, 0) << frames.err;
  EXPECT_TRUE(std::filesystem::exists(folder_.path("loc-12.svg")));
  const auto moving = folder_.path("loc.webp");
  const auto animation = run({"render", map_, "--overlay", overlay, "-o", moving, "--iteration",
                              "all", "--frame-time", "0.1", "--width", "400"});
  EXPECT_EQ(animation.status, 0) << animation.err;
  const auto no_number =
      run({"render", map_, "--overlay", overlay, "-o", picture, "--iteration", "last"});
  EXPECT_NE(no_number.err.find("neither a number from 1 nor 'all'"), std::string::npos)
      << no_number.err;
  EXPECT_EQ(run({"render", map_, "--overlay", overlay, "-o", moving, "--frame-time", "0.1"}).status,
            2);  // a still picture has no frames
  EXPECT_EQ(run({"render", map_, "--overlay", overlay, "-o", moving, "--iteration", "all",
                 "--frame-time", "0"})
                .status,
            2);
}

TEST_F(LocalizeLog, RefusesWhatMakesNoSense) {
  EXPECT_EQ(localize({"--pose", "1,1,0"}).status, 2);
  EXPECT_EQ(localize({"--fov", "90"}).status, 2);
  EXPECT_EQ(localize({"--known-start"}).status, 2);
  EXPECT_EQ(localize({"--likelihood", "report", "--gamma", "1"}).status, 2);
  const auto off_the_map = localize({"--initial-pose", "1000,1,0"});
  EXPECT_EQ(off_the_map.status, 2);
  EXPECT_NE(off_the_map.err.find("outside of the map's border"), std::string::npos)
      << off_the_map.err;
  EXPECT_EQ(localize({"--from-reference"}).status, 2);                   // no reference
  EXPECT_EQ(localize({"--odometry", odometry_, "--kidnap"}).status, 2);  // nowhere to
  EXPECT_EQ(localize({"--first-scan", "3", "--last-scan", "12"}).status, 2);
  EXPECT_EQ(run({"localize", map_, "--pose", "1,1,0", "--odometry", odometry_}).status, 2);
  const auto windows = folder_.file("windows.csv", "first_scan,last_scan\n0,9\n5,12\n");
  const auto beyond = localize({"--odometry", odometry_, "--windows", windows});
  EXPECT_EQ(beyond.status, 3);
  EXPECT_NE(beyond.err.find("windows.csv:3:"), std::string::npos) << beyond.err;
}

TEST_F(LocalizeLog, WarnsOfTheOdometryOfAnotherLog) {
  std::string table = "scan,t,odom_x,odom_y,odom_theta\n";
  for (std::size_t i = 0; i < kScans; ++i) {
    table += std::to_string(i) + ',' + std::to_string(i + (i == 5 ? 7 : 0)) + ",0,0,0\n";
  }
  const auto other = folder_.file("other.csv", table);
  const auto warned = localize({"--odometry", other, "--initial-pose", "2,1.5,0"});
  EXPECT_NE(warned.err.find("other.csv: its times are up to 7.0 s off those of the log's scans"),
            std::string::npos)
      << warned.err;
  const auto own = localize({"--odometry", odometry_, "--initial-pose", "2,1.5,0"});
  EXPECT_EQ(own.err.find("warning"), std::string::npos) << own.err;
}

TEST_F(LocalizeLog, NamesTheLineOfABrokenLog) {
  const auto broken = folder_.file("broken.log", "PARAM x 1\nFLASER 3 1 2\n");
  const auto result = run({"localize", map_, "--log", broken});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("broken.log:2: the line ends before"), std::string::npos) << result.err;
}

TEST(LocalizeRealLog, TracksTheIntelLog) {
  MAPWRIGHT_REQUIRE_REAL_DATA("3_robot/logs");
  const TemporaryFolder folder;
  const auto data = [](const std::string& name) { return real_data("3_robot/" + name).string(); };
  const auto map = folder.path("intel.txt");
  ASSERT_EQ(run({"import", data("derived/intel_full.lines.csv"), "-o", map}).status, 0);
  const auto result = run({"localize", map, "--log", data("logs/intel-corrected.log.gz"),
                           "--odometry", data("derived/intel.odom_ref.csv"), "--first-scan", "431",
                           "--last-scan", "480", "--from-reference"});
  EXPECT_EQ(result.status, 0) << result.out << result.err;
}

}  // namespace
}  // namespace mapwright::test
