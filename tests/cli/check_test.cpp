#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;

class CheckVerb : public testing::Test {
 protected:
  // Without localization, which takes its time.
  ProgramRun check(std::vector<std::string> options) const {
    options.insert(options.begin(), "check");
    options.insert(options.end(), {"--trials", "0", "--plans", "3"});
    return run(options);
  }
  Json check_json(std::vector<std::string> options) const {
    options.insert(options.end(), {"--format", "json"});
    return Json::parse(check(options).out);
  }

  TemporaryFolder folder_;
  std::string good_ = folder_.file("good.txt", format_map(map10({box(1, 4, 4, 6, 6)})));
  std::string full_ = folder_.file("full.txt", format_map(map10({box(1, 0, 0, 10, 10)})));
};

TEST_F(CheckVerb, AnswersByTheContract) {
  const Json answer = check_json({good_});
  EXPECT_EQ(answer.begin().key(), "schema");
  EXPECT_EQ(answer["schema"], "mapwright.check/1");
  ASSERT_EQ(answer["maps"].size(), 1U);
  const Json& map = answer["maps"][0];
  EXPECT_EQ(map["path"], good_);
  EXPECT_EQ(map["verdict"], "pass");
  EXPECT_EQ(map["findings"], Json::array());
  EXPECT_EQ(map["planning"]["trials"], 3);
  EXPECT_EQ(map["planning"]["solved"], 3);
  EXPECT_EQ(map["reachability"]["components"], 1);
  EXPECT_EQ(map["reachability"]["unreachable"], Json::array());
  EXPECT_TRUE(map.contains("localization"));
}

TEST_F(CheckVerb, LocalizationIsPartOfTheVerdict) {
  const ProgramRun once =
      run({"check", good_, "--trials", "1", "--plans", "1", "--format", "json"});
  const Json localization = Json::parse(once.out)["maps"][0]["localization"];
  EXPECT_EQ(localization["trials"], 1);
  EXPECT_TRUE(localization["position_error_m"]["median"].is_number());
  EXPECT_TRUE(localization["position_error_m"]["p95"].is_number());
}

TEST_F(CheckVerb, TextSaysVerdictAndReasons) {
  const ProgramRun pass = check({good_});
  EXPECT_EQ(pass.status, 0);
  EXPECT_NE(pass.out.find(good_ + ": verdict: pass, 0 errors, 0 warnings\n"), std::string::npos)
      << pass.out;
  EXPECT_NE(pass.out.find("planning: 3 of 3 pairs solved"), std::string::npos);
  const ProgramRun fail = check({full_});
  EXPECT_EQ(fail.status, 1);
  EXPECT_NE(fail.out.find("[N101]"), std::string::npos) << fail.out;
  EXPECT_NE(fail.out.find("verdict: fail, 1 error, 0 warnings"), std::string::npos) << fail.out;
}

TEST_F(CheckVerb, ABrokenMapCostsOnlyItself) {
  const std::string garbage = folder_.file("garbage.txt", std::string("\0\1\2\xff#;;", 7));
  const std::string missing = folder_.path("missing.txt");
  const ProgramRun run = check({garbage, missing, good_, "--format", "json"});
  EXPECT_EQ(run.status, 3);
  const Json maps = Json::parse(run.out)["maps"];
  ASSERT_EQ(maps.size(), 3U);
  EXPECT_EQ(maps[0]["verdict"], "fail");
  EXPECT_FALSE(maps[0]["findings"].empty());
  EXPECT_EQ(maps[1]["verdict"], "pass");
  EXPECT_EQ(maps[2]["verdict"], "fail");
  EXPECT_EQ(check({garbage, good_}).status, 1);
}

TEST_F(CheckVerb, WritesToAFile) {
  const std::string report = folder_.path("report.json");
  EXPECT_EQ(check({good_, "--format", "json", "-o", report}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(report));
  EXPECT_EQ(check({good_, "-o", folder_.path("none/report.txt")}).status, 4);
}

TEST_F(CheckVerb, WrongUsage) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {good_, "--robot-radius", "-1"},
      {good_, "--robot-radius", "nan"},
      {good_, "--shard", "0/2"},
      {good_, "--shard", "3/2"},
      {good_, "--shard", "2"},
      {good_, "--jobs", "-1"},
      {good_, "--min-converged", "1.5"},
      {good_, "--ramps", "force"},
      {good_, "--format", "xml"},
      {"-", "-"},
  };
  for (const auto& options : wrong) {
    EXPECT_EQ(check(options).status, 2) << testing::PrintToString(options);
  }
  std::filesystem::create_directories(folder_.path("empty"));
  EXPECT_EQ(check({folder_.path("empty")}).status, 2);
}

}  // namespace
}  // namespace mapwright
