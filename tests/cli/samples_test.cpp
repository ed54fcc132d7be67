// The samples stay what samples/README.md says they are.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "mapcore/text/reader.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::project_file;
using test::run;
using test::TemporaryFolder;
using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string sample(const std::string& name) {
  return project_file("samples/" + name).string();
}

class Samples : public testing::Test {
 protected:
  // Converts and returns the map's text.
  std::string converted(const std::string& source, std::vector<std::string> options) const {
    const std::string map = folder_.path("map.txt");
    options.insert(options.begin(), {"convert", sample(source), "-o", map});
    const auto result = run(options);
    EXPECT_EQ(result.status, 0) << result.err;
    return text_of(map);
  }

  TemporaryFolder folder_;
  const std::vector<std::string> campus_ = {"--rules",        "mapwright",    "--origin",
                                            "319720,4611000", "--origin-crs", "EPSG:25831",
                                            "--heading",      "-30"};
  const std::vector<std::string> square_ = {"--rules", sample("fib_square/rules.yaml"), "--local"};
};

// The drawing's corners, shape by shape: where a ring begins is the format's business.
std::multiset<std::pair<double, double>> corners(const Obstacle& obstacle) {
  std::multiset<std::pair<double, double>> points;
  for (const auto& segment : obstacle.segments) points.insert({segment.a.x, segment.a.y});
  return points;
}

TEST_F(Samples, CampusBecomesItsMap) {
  EXPECT_EQ(converted("campus/campus.gpkg", campus_), text_of(sample("campus/campus.txt")));
}

TEST_F(Samples, SquareBecomesItsMap) {
  EXPECT_EQ(converted("fib_square/fib_square.gpkg", square_),
            text_of(sample("fib_square/fib_square.txt")));
}

TEST_F(Samples, ShapefilesOfTheCampusGiveTheSameStraightObstacles) {
  const Map from_gpkg = read_map(text_of(sample("campus/campus.txt"))).map;
  const Map from_shp = read_map(converted("campus/shp", campus_)).map;
  ASSERT_EQ(from_shp.obstacles.size(), from_gpkg.obstacles.size());
  for (std::size_t i = 0; i < from_gpkg.obstacles.size(); ++i) {
    const Obstacle& expected = from_gpkg.obstacles[i];
    const Obstacle& actual = from_shp.obstacles[i];
    EXPECT_EQ(actual.semantic, expected.semantic);
    const bool curved = expected.shape_type == ShapeType::kClosedCurve ||
                        expected.shape_type == ShapeType::kOpenCurve;
    if (curved) continue;
    EXPECT_EQ(corners(actual), corners(expected)) << expected.id;
  }
}

TEST_F(Samples, SquareStandsWhereTheReportPrintsIt) {
  const Map map = read_map(text_of(sample("fib_square/fib_square.txt"))).map;
  EXPECT_EQ(map.border, (Border{-4, 58, 58, -4}));
  const auto box_of = [&](std::int64_t id) {
    for (const auto& obstacle : map.obstacles) {
      if (obstacle.id == id) return extent(obstacle);
    }
    return kEmptyBox;
  };
  EXPECT_EQ(box_of(1), (Box{4.53, 12.10, 7.29, 13.86}));
  EXPECT_EQ(box_of(2), (Box{8.12, 12.10, 8.86, 13.33}));
  EXPECT_EQ(box_of(13), (Box{7.73, 4, 40.66, 5.30}));
  const auto stairs = std::find_if(map.obstacles.begin(), map.obstacles.end(), [](const auto& o) {
    return o.shape_type == ShapeType::kStairs && o.segments.size() == 11;
  });
  ASSERT_NE(stairs, map.obstacles.end());
  const Segment& top = stairs->segments.back();
  EXPECT_EQ(top.height_m, 0.0);
  EXPECT_EQ(top.a, (Point{34.65, 40.72}));
  EXPECT_EQ(top.b, (Point{57.5, 40.72}));
  const Segment& highest = stairs->segments[9];
  EXPECT_EQ(highest.height_m, 2.0);
  EXPECT_EQ(highest.a, (Point{57.5, 41.02}));
}

TEST_F(Samples, MapsAreFit) {
  const auto result = run({"validate", sample("campus/campus.txt"),
                           sample("fib_square/fib_square.txt"), "--format", "json"});
  EXPECT_EQ(result.status, 0);
  for (const auto& map : Json::parse(result.out)["maps"]) {
    EXPECT_EQ(map["verdict"], "pass");
    for (const auto& finding : map["findings"]) {  // benches are lower than the laser
      EXPECT_EQ(finding["code"], "S121") << finding.dump(1);
    }
  }
}

TEST_F(Samples, EachOfTheEightSlipsIsFound) {
  const auto result = run({"validate", sample("broken/square_broken.txt"), "--format", "json"});
  EXPECT_EQ(result.status, 1);
  std::set<std::string> codes;
  const Json answer = Json::parse(result.out);
  for (const auto& finding : answer["maps"][0]["findings"]) {
    if (finding["severity"] == "error") codes.insert(finding["code"]);
  }
  EXPECT_EQ(codes, (std::set<std::string>{"F107", "F109", "G107", "G109", "S101", "S107", "T101",
                                          "T202"}));
}

}  // namespace
}  // namespace mapwright
