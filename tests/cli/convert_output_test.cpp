// Where `mapwright convert` puts its map, sidecar and ledger, and what is left when it is stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/convert/converted_files.hpp"
#include "converter/rules/rule_reader.hpp"
#include "tests/cli/process.hpp"
#include "tests/support/gis_files.hpp"

namespace mapwright::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kDrawing =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":3},)"
    R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]}}]})";

class Output : public testing::Test {
 protected:
  std::vector<std::string> conversion(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"convert", source_, "--local"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path(""))) {
      const std::string name = entry.path().filename().string();
      if (name.rfind(".std", 0) != 0) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder folder_;
  std::string source_ = folder_.file("site.geojson", kDrawing);
};

TEST_F(Output, AReportCalledDashIsStandardOutput) {
  const auto made = run(conversion({"-o", folder_.path("map.txt"), "--report", "-"}));
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(json::parse(made.out)["totals"]["written"], 1);
  EXPECT_FALSE(fs::exists("-"));
  EXPECT_EQ(files(), (std::vector<std::string>{"map.txt", "site.geojson"}));
}

TEST_F(Output, AReportCalledDashTellsOfALossToo) {
  folder_.file("site.csv", "WKT\nPOLYGON((0 0,4 0\n");
  source_ = folder_.path("site.csv");
  const auto refused = run(conversion({"-o", folder_.path("map.txt"), "--report", "-"}));
  EXPECT_EQ(refused.status, 3) << refused.err;
  EXPECT_EQ(json::parse(refused.out)["totals"]["dropped"], 1);
}

TEST_F(Output, StandardOutputHoldsOneThing) {
  const auto refused = run(conversion({"-o", "-", "--report", "-"}));
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("standard output cannot hold both"), std::string::npos) << refused.err;
}

TEST_F(Output, ASourceCalledDashIsNoPipe) {
  source_ = "-";
  const auto refused = run(conversion({"-o", folder_.path("map.txt")}));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("sources are files"), std::string::npos) << refused.err;
}

// As `mapwright convert … --report - | head` does to a writer.
TEST_F(Output, AReaderThatGoesAwayLeavesNoTemporaryFile) {
  std::string many = R"({"type":"FeatureCollection","features":[)";
  for (int i = 0; i < 500; ++i) {
    many +=
        std::string(i == 0 ? "" : ",") + R"({"type":"Feature","properties":{},"geometry":null})";
  }
  source_ = folder_.file("site.geojson", many + "]}");
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_CLOEXEC), 0);
  const std::string writing_end = "/proc/self/fd/" + std::to_string(ends[1]);
  const ProcessOptions options{"", writing_end, 0};
  const auto child =
      start_process(folder_, conversion({"-o", folder_.path("map.txt"), "--report", "-"}), options);
  ::close(ends[0]);  // not before: opening a pipe that nobody reads would wait
  ::close(ends[1]);
  EXPECT_EQ(wait_for_process(folder_, child, options).status, 128 + SIGPIPE);
  EXPECT_EQ(files(), (std::vector<std::string>{"site.geojson"}));
}

// Ten megabytes of walls; the process that reads them is a megabyte ahead at most.
void write_long_walls(const std::string& path) {
  std::string line = "LINESTRING(0 0";
  for (int i = 1; i < 200; ++i) line += "," + std::to_string(i) + " " + std::to_string(i % 2);
  GisLayer walls{"walls", "", {}, wkbLineString};
  for (int i = 0; i < 3000; ++i) walls.features.push_back({line + ")", {}});
  write_gis(path, "GPKG", {walls});
}

// SQLite maps the database: what is gone of it ends the process that reads (SIGBUS), unless SQLite
// looks at the size first.
TEST_F(Output, AGeoPackageCutShortWhileItIsReadCannotBeRead) {
  const std::string path = folder_.path("walls.gpkg");
  for (const auto kept : {8192U, 5'000'000U}) {
    write_long_walls(path);
    ASSERT_GT(fs::file_size(path), 9'000'000U);
    converter::ConvertOptions options;
    options.sources = {path};
    options.local = true;
    options.rules = *converter::read_rules(std::string(converter::builtin_rules("auto")), "auto");
    bool is_cut = false;
    options.progress = [&](std::size_t done, std::size_t) {
      if (done > 0 && !std::exchange(is_cut, true)) fs::resize_file(path, kept);
    };
    {
      const cli::ConvertedFiles outputs(folder_.path("map.txt"), folder_.path("report.json"));
      const auto refused = converter::convert(options);
      ASSERT_TRUE(is_cut);
      ASSERT_FALSE(refused) << kept;
      EXPECT_EQ(refused.error().kind, FailureKind::kInput);
      EXPECT_EQ(refused.error().message.find(path + ": "), 0U) << refused.error().message;
    }
    EXPECT_EQ(files(), (std::vector<std::string>{"site.geojson", "walls.gpkg"}));
    fs::remove(path);
  }
}

}  // namespace
}  // namespace mapwright::test
