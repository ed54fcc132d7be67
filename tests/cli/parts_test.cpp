// `mapwright crop` and `merge`.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mapcore/georeference.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"
#include "tests/support/file_content.hpp"

namespace mapwright {
namespace {

using test::content;
using test::project_file;
using test::run;
using test::TemporaryFolder;

class Parts : public testing::Test {
 protected:
  std::string crop(const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"crop", campus_, "-o", folder_.path(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return folder_.path(name);
  }

  TemporaryFolder folder_;
  const std::string campus_ = project_file("samples/campus/campus.txt").string();
};

TEST_F(Parts, OfTheCampusMergeToTheCampus) {
  std::vector<std::string> arguments{"merge", "-o", folder_.path("all.txt")};
  for (const std::string tile :
       {"37.5,-1,75.1,45", "0,0,37.5,45", "75.1,0,113,45", "0,45,60,95", "60,45,112,90"}) {
    arguments.push_back(crop("part" + std::to_string(arguments.size()) + ".txt", {"--bbox", tile}));
  }
  const auto result = run(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(content(folder_.path("all.txt")), content(campus_));
  const auto merged = parse_georeference(content(folder_.path("all.georef.json")));
  const auto original = parse_georeference(content(sidecar_path(campus_)));
  ASSERT_TRUE(merged && original);
  EXPECT_EQ(merged->origin_latitude_deg, original->origin_latitude_deg);
  EXPECT_EQ(merged->wkt2, original->wkt2);
  ASSERT_EQ(merged->sources.size(), original->sources.size());
  for (const auto& source : merged->sources) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path(source.path))) << source.path;
  }
}

TEST_F(Parts, CutOnesMergeToTheCampusToo) {
  std::vector<std::string> arguments{"merge", "-o", folder_.path("all.txt")};
  for (const std::string tile : {"0,0,37.5,45", "37.5,0,112,45", "0,45,60,90", "50,45,112,90"}) {
    arguments.push_back(
        crop("part" + std::to_string(arguments.size()) + ".txt", {"--bbox", tile, "--cut"}));
    EXPECT_NE(content(arguments.back()).find("cut="), std::string::npos) << tile;
  }
  const auto result = run(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(content(folder_.path("all.txt")), content(campus_));
  // A piece that somebody has raised is no piece of it any more.
  Map edited = read_map(content(arguments.back())).map;
  const auto piece =
      std::find_if(edited.obstacles.begin(), edited.obstacles.end(),
                   [](const Obstacle& o) { return o.semantic.value("cut").has_value(); });
  ASSERT_NE(piece, edited.obstacles.end());
  piece->segments.front().height_m += 1.0;
  std::ofstream(arguments.back(), std::ios::binary) << format_map(edited);
  const auto refused = run(arguments);
  EXPECT_EQ(refused.status, 2) << refused.err;
  EXPECT_NE(refused.err.find("crop that part anew"), std::string::npos) << refused.err;
}

TEST_F(Parts, CutOnesAreValidButForStairsAndRampsAcrossTheEdge) {
  const std::string part = crop("cut.txt", {"--bbox", "20,10,80,70", "--cut"});
  const Map map = read_map(content(part)).map;
  EXPECT_EQ(map.border, (Border{20, 70, 80, 10}));
  EXPECT_GT(map.obstacles.size(), 5U);
  const auto result = run({"validate", part, "--format", "json"});
  for (const auto& finding : nlohmann::json::parse(result.out)["maps"][0]["findings"]) {
    if (finding["severity"] != "error") continue;
    EXPECT_EQ(finding["code"], "G109") << finding;
    const auto is_it = [&](const Obstacle& o) { return o.id == finding["obstacle"]; };
    const auto found = std::find_if(map.obstacles.begin(), map.obstacles.end(), is_it);
    ASSERT_NE(found, map.obstacles.end());
    EXPECT_TRUE(found->shape_type == ShapeType::kStairs || found->shape_type == ShapeType::kRamp);
  }
}

TEST_F(Parts, DiscGoesToStandardOutput) {
  const auto result = run({"crop", campus_, "-o", "-", "--circle", "40,30,20"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(read_map(result.out).map.border, (Border{20, 50, 60, 10}));
}

TEST_F(Parts, RefusesWhatMakesNoSense) {
  const auto refused = [&](std::vector<std::string> arguments, int status,
                           const std::string& words) {
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  const std::string out = folder_.path("out.txt");
  refused({"crop", campus_, "-o", out}, 2, "either --bbox or --circle");
  refused({"crop", campus_, "-o", out, "--bbox", "5,5,1,9"}, 2, "--bbox");
  refused({"crop", campus_, "-o", out, "--bbox", "500,500,510,510"}, 2, "no area in common");
  refused({"crop", campus_, "-o", out, "--circle", "5,5,0"}, 2, "radius");
  refused({"crop", campus_, "-o", out, "--circle", "5,5,1", "--cut"}, 2, "--cut");
  refused({"crop", campus_, "-o", folder_.path("none/o.txt"), "--circle", "5,5,1"}, 4, "folder");
  refused({"merge", campus_, folder_.path("none.txt"), "-o", out}, 3, "none.txt");
  const std::string square = project_file("samples/fib_square/fib_square.txt").string();
  refused({"merge", campus_, square, "-o", out}, 2, "--same-frame");
  refused({"merge", campus_, "-o", out, "--prefer", "best"}, 2, "--prefer");
  const std::string other = crop("other.txt", {"--bbox", "0,0,50,50"});
  std::string sidecar = content(sidecar_path(other));
  sidecar.replace(sidecar.find("41.63"), 5, "41.64");
  folder_.file("other.georef.json", sidecar);
  refused({"merge", campus_, other, "-o", out}, 2, "another frame");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Parts, VersionsOfAnObstacleNeedAChoice) {
  std::string text = content(campus_);
  const auto at = text.find("44;82;\n14;1;");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 9, "44;82;\n15");
  const std::string edited = folder_.file("edited.txt", text);
  folder_.file("edited.georef.json", content(sidecar_path(campus_)));
  const auto refused = run({"merge", campus_, edited, "-o", folder_.path("out.txt")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("obstacle 1 is not the same"), std::string::npos) << refused.err;
  const auto merged =
      run({"merge", campus_, edited, "-o", folder_.path("out.txt"), "--prefer", "last"});
  EXPECT_EQ(merged.status, 0) << merged.err;
  EXPECT_EQ(content(folder_.path("out.txt")), text);
}

}  // namespace
}  // namespace mapwright
