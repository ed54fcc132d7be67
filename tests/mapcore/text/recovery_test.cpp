// What the reader saves of damaged text.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "bench/support/campus_generator.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/mapcore/text/samples.hpp"

namespace mapwright {
namespace {

using test::kTriangle;
using test::Report;
using test::reports;
using test::with;

Map triangle() {
  return read_map(kTriangle).map;
}

std::string without(std::string text, const std::string& what) {
  for (auto at = text.find(what); at != text.npos; at = text.find(what))
    text.erase(at, what.size());
  return text;
}

TEST(Recovery, LostHashesLoseNothing) {
  const std::string text = format_map(bench::generate_campus({100.0, 520, 4}));
  const MapDocument whole = read_map(text);
  ASSERT_TRUE(whole.findings.empty());
  const MapDocument damaged = read_map(without(text, "#\n"));
  EXPECT_EQ(damaged.map, whole.map);
  const auto records = 1 + whole.map.obstacles.size() + segment_count(whole.map);
  ASSERT_EQ(damaged.findings.size(), records);
  for (const auto& finding : damaged.findings) EXPECT_EQ(finding.code, FindingCode::F107);
}

TEST(Recovery, OneDefectALineCostsOneRecordEach) {
  std::string text = format_map(bench::generate_campus({100.0, 520, 4}));
  const Map whole = read_map(text).map;
  std::size_t damaged = 0;
  for (auto at = text.find(";1;wall,grey"); at != text.npos; at = text.find(";1;wall,grey", at + 9)) {
    text.insert(at, "x");
    ++damaged;
  }
  const MapDocument document = read_map(text);
  EXPECT_GT(damaged, 100U);
  EXPECT_EQ(document.findings.size(), damaged);
  EXPECT_EQ(segment_count(document.map), segment_count(whole) - damaged);
  EXPECT_EQ(document.map.obstacles.size(), whole.obstacles.size());
}

TEST(Recovery, EveryBadFieldOfARecordIsNamed) {
  const auto document = read_map(with(kTriangle, "1;0;\n0;1;\n5;1;door", "a;b;\n0;c;\nd;e;door"));
  EXPECT_EQ(reports(document.findings), (std::vector<Report>{{"F109", 12, 1, 1, 2},
                                                             {"F109", 12, 3, 1, 2},
                                                             {"F109", 13, 3, 1, 2},
                                                             {"F109", 14, 1, 1, 2},
                                                             {"F115", 14, 3, 1, 2}}));
  EXPECT_EQ(document.map.obstacles.at(0).segments.size(), 2U);
}

TEST(Recovery, DeclaredSegmentsAllocateNothing) {
  const auto document = read_map(with(kTriangle, "1;1;3", "1;1;1000000000"));
  EXPECT_EQ(document.map, triangle());
  EXPECT_LE(document.map.obstacles[0].segments.capacity(), 8U);
}

TEST(Recovery, UnknownShapeTypeIsWhatTheChainShows) {
  const auto closed = read_map(with(kTriangle, "1;1;3", "1;7;3"));
  EXPECT_EQ(closed.map.obstacles.at(0).shape_type, ShapeType::kClosedPolygon);
  const auto open = read_map(with(with(kTriangle, "1;1;3", "1;7;3"), "0;1;\n0;0;", "0;1;\n0;2;"));
  EXPECT_EQ(open.map.obstacles.at(0).shape_type, ShapeType::kOpenPolygon);
  const auto words = read_map(with(kTriangle, "1;1;3", "1;polygon;3"));
  EXPECT_EQ(reports(words.findings), (std::vector<Report>{{"F111", 6, 3, 1}}));
  EXPECT_EQ(words.map, triangle());
}

TEST(Recovery, ObstacleWithoutIdIsLeftOutWithItsSegments) {
  const auto document = read_map(with(kTriangle, "1;1;3", "one;1;3") + "obstacle;2;1;0;none;#");
  ASSERT_EQ(document.map.obstacles.size(), 1U);
  EXPECT_EQ(document.map.obstacles[0].id, 2);
  EXPECT_TRUE(document.map.obstacles[0].segments.empty());
  EXPECT_EQ(document.findings.size(), 1U);
}

TEST(Recovery, BadInOutReadsAsOutdoor) {
  EXPECT_EQ(read_map(with(kTriangle, "5;1;door", "5;yes;door")).map, triangle());
}

TEST(Recovery, SemanticStringsAreRepaired) {
  const auto label = [](const std::string& written) {
    return read_map(with(kTriangle, "door;", written))
        .map.obstacles.at(0)
        .segments.at(1)
        .semantic.str();
  };
  EXPECT_EQ(label(""), "");
  EXPECT_EQ(label("door"), "door");
  EXPECT_EQ(label("door;wood;"), "door,wood");
  EXPECT_EQ(label("door; two wings; wood"), "door,two wings,wood");
  EXPECT_EQ(label("door\n\n wood ;"), "door wood");
  EXPECT_EQ(label("Pla\xE7"
                  "a;"),
            "Pla\xE7"
            "a");
}

TEST(Recovery, KeywordsAreRecognised) {
  for (const char* written : {"Obstacle;", "OBSTACLE\n;", "obstacle", "obstcle;", ". obstacle;"}) {
    const auto document = read_map(with(kTriangle, "obstacle;", written));
    EXPECT_EQ(document.map, triangle()) << written;
    EXPECT_EQ(document.findings.size(), 1U) << written;
  }
}

TEST(Recovery, LabelsThatLookLikeKeywordsStayLabels) {
  const std::string lost =
      with(with(kTriangle, "wall;\n#", "obstacle;\n"), "door;\n#", "border;\n");
  const auto document = read_map(lost);
  EXPECT_EQ(reports(document.findings), (std::vector<Report>{{"F107", 10, 14}, {"F107", 14, 12}}));
  const auto& segments = document.map.obstacles.at(0).segments;
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].semantic.view(), "obstacle");
  EXPECT_EQ(segments[1].semantic.view(), "border");
}

TEST(Recovery, HeaderInsideOfASegmentEndsIt) {
  const auto document =
      read_map(with(kTriangle, "0;1;\n0;0;\n5;1;wall;\n#\n", "0;1;\nobstacle;2;2;0;wall;#\n"));
  ASSERT_EQ(document.map.obstacles.size(), 2U);
  EXPECT_EQ(document.map.obstacles[1].id, 2);
  EXPECT_EQ(reports(document.findings),
            (std::vector<Report>{{"F108", 16, 1, 1, 3}, {"F107", 16, 5}}));
}

TEST(Recovery, ReadsUpToWhereTheTextEnds) {
  std::string text = kTriangle;
  while (text.size() < 5000) text += "obstacle;2;2;0;wall;#\n";
  const std::size_t lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  text.resize(8192, ' ');
  text += std::string(1000, '\x02') + "#obstacle;3;2;0;wall;#";
  const auto document = read_map(text);
  EXPECT_EQ(reports(document.findings),
            (std::vector<Report>{{"F102", lines + 1, 8192 - text.rfind('\n', 8191)}}));
  EXPECT_EQ(document.map.obstacles.at(0), triangle().obstacles[0]);
  EXPECT_EQ(document.map.obstacles.back().id, 2);
}

}  // namespace
}  // namespace mapwright
