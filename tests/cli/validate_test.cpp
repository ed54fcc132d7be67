#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "mapcore/georeference.hpp"
#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::run;
using test::TemporaryFolder;

constexpr const char* kFit =
    "border;0;10;10;0;#\n"
    "obstacle;1;1;3;column;#\n2;2;4;2;3;1;wall;#\n4;2;4;4;3;1;wall;#\n4;4;2;2;3;1;wall;#\n";
constexpr const char* kNotFit = "border;0;10;10;0;#\nobstacle;1;2;1;fence;#\n2;2;2;2;3;1;wall;#\n";
constexpr const char* kWithWarning = "border;0;10;10;0;#\nobstacle;1;2;1; ;#\n2;2;4;2;3;1;wall;#\n";

TEST(Validate, PassesAFitMap) {
  const TemporaryFolder folder;
  const auto result = run({"validate", folder.file("map.txt", kFit)});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "1 map: 1 fit, 0 not; 0 errors, 0 warnings\n");
}

TEST(Validate, NamesThePlaceOfADefect) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", kNotFit);
  const auto result = run({"validate", path});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out,
            path +
                ":3:1: error: segment 1 of obstacle 1 begins and ends at (2, 2); remove "
                "it and count it off [G103]\n  2;2;2;2;3;1;wall;#\n  ^\n");
  EXPECT_EQ(result.err, "1 map: 0 fit, 1 not; 1 error, 0 warnings\n");
}

TEST(Validate, WarningsDoNotFail) {
  const TemporaryFolder folder;
  const auto result = run({"validate", "--quiet", folder.file("map.txt", kWithWarning)});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("[S103]"), std::string::npos);
  EXPECT_EQ(result.err, "");
}

TEST(Validate, ReportsTheOtherMapsWhereOneCannotBeRead) {
  const TemporaryFolder folder;
  const std::string fit = folder.file("fit.txt", kFit);
  const std::string missing = folder.path("missing.txt");
  const std::string broken = folder.file("broken.txt", kNotFit);
  const auto result = run({"validate", fit, missing, broken, "--format", "json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find(missing), std::string::npos);
  const json report = json::parse(result.out);
  EXPECT_EQ(report["schema"], "mapwright.validate/1");
  ASSERT_EQ(report["maps"].size(), 3U);
  EXPECT_EQ(report["maps"][0]["path"], fit);
  EXPECT_EQ(report["maps"][0]["verdict"], "pass");
  EXPECT_EQ(report["maps"][1]["verdict"], "fail");
  EXPECT_TRUE(report["maps"][1].contains("unreadable"));
  EXPECT_EQ(report["maps"][2]["findings"][0]["code"], "G103");
  EXPECT_EQ(report["maps"][2]["findings"][0]["line"], 3);
}

TEST(Validate, WritesToTheFileThatIsNamed) {
  const TemporaryFolder folder;
  const std::string report = folder.path("report.json");
  const auto result =
      run({"validate", folder.file("map.txt", kNotFit), "--format", "json", "-o", report});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  std::ifstream in(report);
  EXPECT_EQ(json::parse(in)["maps"][0]["verdict"], "fail");
  EXPECT_EQ(run({"validate", folder.path("map.txt"), "-o", folder.path("no/such/folder")}).status,
            4);
}

TEST(Validate, ReadsTheSidecarToo) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kFit);
  folder.file("map.georef.json", "{\"schema\": ");
  const auto result = run({"validate", map});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("map.georef.json"), std::string::npos);
  EXPECT_NE(result.out.find("[C101]"), std::string::npos);
  folder.file("map.georef.json", format_georeference({41.4, 2.1, 100.0, 0.0, {}, "", {}}));
  EXPECT_EQ(run({"validate", map}).status, 0);
}

TEST(Validate, ListsAndExplainsTheFindings) {
  const auto list = run({"validate", "--list"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("G104  error     outline_self_intersection"), std::string::npos);
  const auto page = run({"validate", "--explain", "G104"});
  EXPECT_EQ(page.status, 0);
  EXPECT_TRUE(page.out.starts_with("# G104 outline_self_intersection\n"));
}

TEST(Validate, RefusesWhatMakesNoSense) {
  EXPECT_EQ(run({"validate"}).status, 2);
  EXPECT_EQ(run({"validate", "--explain", "G999"}).status, 2);
  EXPECT_EQ(run({"validate", "map.txt", "--format", "xml"}).status, 2);
}

}  // namespace
}  // namespace mapwright
