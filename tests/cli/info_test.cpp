#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/support/campus_generator.hpp"
#include "cli/info/map_summary.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::run;
using test::TemporaryFolder;

// A unit square of height 2, indoors, and two steps with their top.
constexpr const char* kSquareAndStairs =
    "border;\n0;10;\n20;0;\n#\n"
    "obstacle;\n7;1;4;column;\n#\n"
    "1;1;\n2;1;\n2;0;brick;\n#\n2;1;\n2;2;\n2;0;brick;\n#\n"
    "2;2;\n1;2;\n2;0;brick;\n#\n1;2;\n1;1;\n2;0;brick;\n#\n"
    "obstacle;\n8;5;3;step;\n#\n"
    "4;1;\n8;1;\n0.2;1;;\n#\n4;2;\n8;2;\n0.4;1;;\n#\n8;3;\n4;3;\n0;1;;\n#\n";

TEST(Info, CountsWhatIsThere) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", kSquareAndStairs);
  const auto result = run({"info", path, "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const json info = json::parse(result.out);
  EXPECT_EQ(result.out.find("{\n  \"schema\": \"mapwright.info/1\""), 0U);
  EXPECT_EQ(info["obstacles"], 2);
  EXPECT_EQ(info["segments"], 7);
  EXPECT_EQ(info["by_shape_type"], json::parse(R"({"1":1,"2":0,"3":0,"4":0,"5":1,"6":0})"));
  EXPECT_EQ(info["segments_by_shape_type"],
            json::parse(R"({"1":4,"2":0,"3":0,"4":0,"5":3,"6":0})"));
  EXPECT_EQ(info["border"], json::parse("[0.0, 10.0, 20.0, 0.0]"));
  EXPECT_EQ(info["extent"], json::parse("[1.0, 1.0, 8.0, 3.0]"));
  EXPECT_EQ(info["bytes"], std::string(kSquareAndStairs).size());
  const double bytes_per_m2 = static_cast<double>(std::string(kSquareAndStairs).size()) / 200.0;
  EXPECT_EQ(info["bytes_per_m2"], bytes_per_m2);
  EXPECT_EQ(info["bits_per_m2"], 8.0 * bytes_per_m2);
  EXPECT_EQ(info["in_out"], json::parse(R"({"indoor":4,"outdoor":3})"));
  EXPECT_EQ(info["length_m"], 16.0);
  EXPECT_EQ(info["height_m"]["max"], 2.0);
  EXPECT_EQ(info["height_m"]["median"], 2.0);
  EXPECT_EQ(info["segments_of_height_0"], 1);
  EXPECT_EQ(info["bounding_circles"]["largest"]["obstacle"], 8);
  EXPECT_NEAR(info["bounding_circles"]["largest"]["radius_m"].get<double>(), std::sqrt(5.0), 1e-9);
  EXPECT_NEAR(info["bounding_circles"]["radius_m"]["min"].get<double>(), std::sqrt(0.5), 1e-9);
  EXPECT_EQ(info["distinct_semantics"], 3);
  EXPECT_TRUE(info["georeference"].is_null());
}

TEST(Info, ShowsTheGeoreferenceBesideTheMap) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", kSquareAndStairs);
  Georeference georeference;
  georeference.origin_latitude_deg = 41.389;
  georeference.heading_deg = -20.0;
  folder.file("map.georef.json", format_georeference(georeference));
  const auto result = run({"info", path, "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["georeference"]["origin"]["latitude"], 41.389);
  EXPECT_NE(run({"info", path}).out.find("origin 41.389, 0 (WGS 84)"), std::string::npos);
}

TEST(Info, SidecarWithoutSenseIsAFinding) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", kSquareAndStairs);
  const std::string sidecar = folder.file("map.georef.json", "{}");
  const auto result = run({"info", path, "--format", "json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, sidecar + ": error: georeference: \"schema\" is missing [C101]\n");
  EXPECT_EQ(json::parse(result.out)["segments"], 7);
}

TEST(Info, SaysWhatIsWrongWithTheText) {
  const TemporaryFolder folder;
  std::string text = kSquareAndStairs;
  text.replace(text.find("0.2;1;;"), 3, "0,2");
  const std::string path = folder.file("map.txt", text);
  const auto result = run({"info", path, "--format", "json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, path +
                            ":29:1: error: segment 1 of obstacle 8: h '0,2' has a decimal comma; "
                            "write 0.2 [F109]\n");
  EXPECT_EQ(json::parse(result.out)["segments"], 6);
  EXPECT_EQ(json::parse(result.out)["findings"]["error"], 1);
}

TEST(Info, TextNamesEveryFigure) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", kSquareAndStairs);
  const std::string text = run({"info", path}).out;
  for (const char* part :
       {"2 with 7 segments, 16 m in all", "ST 1 closed polygon: 1 with 4 segments",
        "ST 5 stairs: 1 with 3 segments", "4 segments indoor, 3 outdoor",
        "(0, 10) to (20, 0), 20 m x 10 m = 200 m2", "bytes/m2", "bits/m2", "largest: obstacle 8",
        "plain local metres", "0 errors, 0 warnings"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  EXPECT_EQ(text.find("ramp"), std::string::npos);
}

TEST(Info, MapsOfTheReportsDensityHaveItsCompactness) {
  const TemporaryFolder folder;
  const std::string path =
      folder.file("campus.txt", format_map(bench::generate_campus(bench::kCampus100m)));
  const json info = json::parse(run({"info", path, "--format", "json"}).out);
  EXPECT_NEAR(info["bytes_per_m2"].get<double>(), 3.0, 0.3);
}

TEST(Info, MapWithoutAreaHasNoDensity) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.txt", "border;0;0;0;0;#");
  const json info = json::parse(run({"info", path, "--format", "json"}).out);
  EXPECT_TRUE(info["bytes_per_m2"].is_null());
  EXPECT_TRUE(info["extent"].is_null());
  EXPECT_EQ(run({"info", path}).status, 0);
}

TEST(Info, RefusesWhatItCannotDo) {
  EXPECT_EQ(run({"info"}).status, 2);
  EXPECT_EQ(run({"info", "a.txt", "--format", "xml"}).status, 2);
  const auto missing = run({"info", "no-such-folder/map.txt"});
  EXPECT_EQ(missing.status, 3);
  EXPECT_EQ(missing.out, "");
  EXPECT_NE(missing.err.find("no-such-folder/map.txt"), std::string::npos);
}

TEST(Spread, IsByNearestRank) {
  const cli::Spread spread = cli::spread_of({4, 1, 3, 2});
  EXPECT_EQ(spread.min, 1.0);
  EXPECT_EQ(spread.median, 2.0);
  EXPECT_EQ(spread.mean, 2.5);
  EXPECT_EQ(spread.p95, 4.0);
  EXPECT_EQ(spread.max, 4.0);
  EXPECT_EQ(cli::spread_of({}).max, 0.0);
}

}  // namespace
}  // namespace mapwright
