// The sample the report prints lost lines and '#' marks on its way through a PDF: the reader must
// name each damage and save the rest.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "mapcore/text/reader.hpp"

namespace mapwright {
namespace {

// Map file sample of the report's appendix A, as its recovered text has it.
constexpr const char* kSample =
    R"(border; -4;58; 58;-4; # obstacle; 1;1;4;column,A5; # "
4.53;12.10;
7.29;12.10;
5;1;wall,orange,brick; # 7.29;12.10; 7.29;13.86; 5;1;wall,orange,brick; # 7.29;13.86; 4.53;13.86; 5;1;wall,orange,brick; # 4.53;13.86; 4.53;12.10; 5;1;wall,orange,brick; # obstacle; 2;1;4;column,A5; # 8.12;12.10; 8.86;12.10; 5;1;wall,orange,brick; 8.86;12.10; 8.86;13.33; 5;1;wall,orange,brick; # 8.12;13.33; 5;1;wall,orange,brick; # 8.12;13.33; 8.12;12.10; 5;1;wall,orange,brick; . obstacle; 13;1;4;bench,A5; # 0.5;1;wall,grey,cement; # #
40.66;4;
40.66;5.30;
0.5;1;wall,grey,cement;
" # 40.66;5.30; 7.73;5.30; 0.5;1;wall,grey,cement; # 7.73;5.30; 7.73;4; 0.5;1;wall,grey,cement; . obstacle; 26;5;4;step,FIBsquare; # 34.65;40.72; 57.5;40.72; 0;1;wall,grey,cement; # 57.5;41.02; 34.65;41.02;

2;1;wall,grey,cement; # 57.5;41.32; 34.65;41.32; 1.8;1;wall,grey,cement; # 57.5;41.62; 34.65;41.62; 1.6;1;wall,grey,cement; #)";

using Place = std::tuple<std::string, std::size_t, std::size_t>;

std::vector<Place> places(const std::vector<Finding>& findings) {
  std::vector<Place> result;
  for (const auto& finding : findings) {
    result.emplace_back(finding_type(finding.code).id, finding.place->line, finding.place->column);
  }
  return result;
}

TEST(ReportSample, HasAFindingForEachDamage) {
  const MapDocument document = read_map(kSample);
  const std::vector<Place> expected{
      {"F117", 1, 54},   // a quotation mark before the first segment of column 1
      {"F107", 4, 248},  // no '#' between the first two segments of column 2
      {"F108", 4, 298},  // the third lost its first point
      {"F107", 4, 381},  // no '#' before bench 13 …
      {"F117", 4, 382},  // … but a dot
      {"F108", 4, 413},  // the bench's first segment lost both points
      {"F119", 4, 439},  // nothing between two '#'
      {"F117", 8, 1},    // a quotation mark behind the second
      {"F107", 8, 96},   // no '#' before stairs 26 …
      {"F117", 8, 97},   // … but a dot
  };
  EXPECT_EQ(places(document.findings), expected);
}

TEST(ReportSample, RecoversTheGoodObstacles) {
  const Map map = read_map(kSample).map;
  EXPECT_EQ(map.border, (Border{-4, 58, 58, -4}));
  ASSERT_EQ(map.obstacles.size(), 4U);
  const auto& [column1, column2, bench, stairs] =
      std::tie(map.obstacles[0], map.obstacles[1], map.obstacles[2], map.obstacles[3]);

  EXPECT_EQ(column1.id, 1);
  EXPECT_EQ(column1.semantic.view(), "column,A5");
  EXPECT_EQ(chain_points(column1),
            (std::vector<Point>{{4.53, 12.1}, {7.29, 12.1}, {7.29, 13.86}, {4.53, 13.86}}));

  EXPECT_EQ(column2.id, 2);
  ASSERT_EQ(column2.segments.size(), 3U);
  EXPECT_EQ(column2.segments[1].b, (Point{8.86, 13.33}));
  EXPECT_EQ(column2.segments[2].b, (Point{8.12, 12.1}));

  EXPECT_EQ(bench.id, 13);
  ASSERT_EQ(bench.segments.size(), 3U);
  EXPECT_EQ(bench.segments[0].a, (Point{40.66, 4}));
  EXPECT_EQ(bench.segments[2].height_m, 0.5);

  EXPECT_EQ(stairs.id, 26);
  EXPECT_EQ(stairs.shape_type, ShapeType::kStairs);
  ASSERT_EQ(stairs.segments.size(), 4U);
  EXPECT_EQ(stairs.segments[0].height_m, 0.0);
  EXPECT_EQ(stairs.segments[1].height_m, 2.0);
  EXPECT_EQ(stairs.segments[3].a, (Point{57.5, 41.62}));
}

TEST(ReportSample, NamesObstacleAndSegment) {
  const auto findings = read_map(kSample).findings;
  ASSERT_EQ(findings.size(), 10U);
  EXPECT_EQ(findings[2].obstacle, 2);
  EXPECT_EQ(findings[2].segment, 3U);
  EXPECT_EQ(findings[5].obstacle, 13);
  EXPECT_EQ(findings[5].segment, 1U);
}

}  // namespace
}  // namespace mapwright
