// Configuration files, suppressions and baselines, as a user meets them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::run;
using test::TemporaryFolder;

constexpr const char* kMap =
    "border;0;10;10;0;#\nobstacle;1;2;1; ;#\n2;2;4;2;3;1;wall;#\n"
    "obstacle;2;2;1;fence;#\n8;2;14;2;3;1;wall;#\n";

constexpr const char* kSuppression =
    "suppressions:\n  - code: G109\n    obstacle: 2\n    reason: the gate opens outwards\n";

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Config, IsFoundBesideTheMapAndAbove) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("a/b"));
  const std::string map = folder.file("a/b/map.txt", kMap);
  EXPECT_EQ(run({"validate", map}).status, 1);
  folder.file(".mapwright.yaml", kSuppression);
  const auto result = run({"validate", map});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "1 map: 1 fit, 0 not; 0 errors, 1 warning; 1 suppressed\n");
  EXPECT_EQ(run({"validate", map, "--no-config"}).status, 1);
  // The nearest one is taken alone.
  folder.file("a/.mapwright.yaml", "checks: {S103: off}\n");
  const auto nearer = run({"validate", map});
  EXPECT_EQ(nearer.status, 1);
  EXPECT_EQ(nearer.err, "1 map: 0 fit, 1 not; 1 error, 0 warnings\n");
}

TEST(Config, MayBeNamed) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string config = folder.file("site.yaml", kSuppression);
  EXPECT_EQ(run({"validate", map, "--config", config}).status, 0);
  EXPECT_EQ(run({"check", map, "--config", config, "--trials", "0", "--plans", "0"}).status, 0);
  EXPECT_EQ(run({"check", map, "--trials", "0", "--plans", "0"}).status, 1);
  EXPECT_EQ(run({"validate", map, "--config", config, "--no-config"}).status, 2);
  EXPECT_EQ(run({"validate", map, "--config", folder.path("none.yaml")}).status, 3);
}

TEST(Config, MistakesAreToldWithTheirPlaces) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string config = folder.file("site.yaml", "suppressions:\n  - code: G109\n");
  const auto result = run({"validate", map, "--config", config});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("site.yaml:2:5: error: the suppression gives no reason"),
            std::string::npos)
      << result.err;
}

TEST(Config, ProfilesChangeTheExitStatus) {
  const TemporaryFolder folder;
  const std::string map =
      folder.file("map.txt", "border;0;10;10;0;#\nobstacle;1;2;1; ;#\n2;2;4;2;3;1;wall;#\n");
  EXPECT_EQ(run({"validate", map}).status, 0);
  EXPECT_EQ(run({"validate", map, "--profile", "strict"}).status, 1);
  const auto unknown = run({"validate", map, "--profile", "stict"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("did you mean strict?"), std::string::npos);
}

TEST(Config, RobotOfTheProfileYieldsToTheCommandLine) {
  const TemporaryFolder folder;
  const std::string map =
      folder.file("map.txt", "border;0;10;10;0;#\nobstacle;1;2;1;wall;#\n2;2;4;2;3;1;wall;#\n");
  const std::string config = folder.file("site.yaml", "robot: {radius_m: 0.45}\n");
  const auto radius = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"check", map,       "--config", config,     "--trials",
                                       "0",     "--plans", "0",        "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(run(arguments).out)["maps"][0]["reachability"]["radius_m"];
  };
  EXPECT_EQ(radius({}), 0.45);
  EXPECT_EQ(radius({"--robot-radius", "0.2"}), 0.2);
}

TEST(Config, UnusedAndExpiredSuppressionsStandAtTheirPlace) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string config =
      folder.file("site.yaml", std::string(kSuppression) +
                                   "    until: 2027-01-01\n  - {code: G104, reason: x}\n");
  const auto before = run({"validate", map, "--config", config, "--today", "2027-01-01"});
  EXPECT_EQ(before.status, 0);
  EXPECT_NE(before.out.find("site.yaml:6:5: warning: the suppression of G104 covers nothing"),
            std::string::npos)
      << before.out;
  const auto after = run({"validate", map, "--config", config, "--today", "2027-01-02"});
  EXPECT_EQ(after.status, 1);
  EXPECT_NE(after.out.find("site.yaml:2:5: warning: the suppression of G109 held until 2027-01-01"),
            std::string::npos)
      << after.out;
  // A shard does not know what the others need.
  const auto shard = run({"check", map, map, "--shard", "1/2", "--config", config, "--today",
                          "2027-01-01", "--trials", "0", "--plans", "0"});
  EXPECT_EQ(shard.out.find("covers nothing"), std::string::npos) << shard.out;
}

TEST(Config, JsonTellsWhatWasSuppressed) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  folder.file(".mapwright.yaml", kSuppression);
  const json report = json::parse(run({"validate", map, "--format", "json"}).out)["maps"][0];
  EXPECT_EQ(report["verdict"], "pass");
  ASSERT_EQ(report["suppressed"].size(), 1U);
  EXPECT_EQ(report["suppressed"][0]["code"], "G109");
  EXPECT_EQ(report["suppressed"][0]["reason"], "the gate opens outwards");
  EXPECT_EQ(report["findings"][0]["fingerprint"].get<std::string>().size(), 16U);
}

TEST(Baselines, LetOnlyNewFindingsCount) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string baseline = folder.path("base.json");
  EXPECT_EQ(run({"validate", map, "--write-baseline", baseline}).status, 0);
  const auto known = run({"validate", map, "--baseline", baseline});
  EXPECT_EQ(known.status, 0);
  EXPECT_EQ(known.out, "");
  EXPECT_EQ(known.err, "1 map: 1 fit, 0 not; 0 errors, 0 warnings; 2 suppressed\n");
  // Other lines, other ids, and one new defect.
  folder.file("map.txt",
              "\nborder;0;10;10;0;#\nobstacle;5;2;1;fence;#\n8;2;14;2;3;1;wall;#\n"
              "obstacle;6;2;1; ;#\n2;2;4;2;3;1;wall;#\nobstacle;7;2;1;new;#\n5;5;5;5;3;1;wall;#\n");
  const auto news = run({"validate", map, "--baseline", baseline});
  EXPECT_EQ(news.status, 1);
  EXPECT_NE(news.out.find("[G103]"), std::string::npos);
  EXPECT_EQ(news.out.find("[G109]"), std::string::npos);
  EXPECT_EQ(run({"check", map, "--baseline", baseline, "--trials", "0", "--plans", "0"}).status, 1);
}

TEST(Baselines, MayBeWrittenAnewOverThemselves) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const std::string baseline = folder.path("base.json");
  run({"validate", map, "--write-baseline", baseline});
  const std::string first = read(baseline);
  EXPECT_EQ(run({"validate", map, "--baseline", baseline, "--write-baseline", baseline}).status, 0);
  EXPECT_EQ(json::parse(read(baseline))["maps"][0]["findings"].size(),
            json::parse(first)["maps"][0]["findings"].size());
}

TEST(Baselines, SayWhatTheyAreNot) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kMap);
  const auto result = run({"validate", map, "--baseline", map});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("is no baseline"), std::string::npos);
  EXPECT_EQ(run({"check", map, "--shard", "1/2", "--write-baseline", folder.path("b")}).status, 2);
}

}  // namespace
}  // namespace mapwright
