// The HTML report as text; tests/browser looks at it in a browser.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "mapcore/text/reader.hpp"
#include "validators/report/html/scene.hpp"
#include "validators/report/report.hpp"

namespace mapwright::validators {
namespace {

using Json = nlohmann::json;

std::string written(const std::vector<MapReport>& maps) {
  std::ostringstream out;
  const auto writer = find_report_format("html")->make(out, {"validate", false});
  for (const auto& map : maps) writer->map(map);
  writer->finish();
  return out.str();
}

std::size_t count(std::string_view text, std::string_view word) {
  std::size_t found = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

// The blocks of data of a class, parsed.
std::vector<Json> blocks(const std::string& page, const std::string& attributes) {
  const std::string begin = "<script type=\"application/json\" " + attributes + ">";
  std::vector<Json> found;
  for (auto at = page.find(begin); at != page.npos; at = page.find(begin, at + 1)) {
    const auto start = at + begin.size();
    found.push_back(Json::parse(page.substr(start, page.find("</script>", start) - start)));
  }
  return found;
}

constexpr std::string_view kText =
    "border;0;10;10;0;#\n"
    "obstacle;7;1;4;</script><script>alert(1)</script>;#\n"
    "1;1;9;1;3;1;<!--;#\n9;1;9;9;3;1;wall;#\n9;9;1;9;3;0;wall;#\n1;9;1;1;2;1;wall;#\n"
    "obstacle;8;1;3;court,inner_of=7;#\n"
    "3;3;3;5;3;1;wall;#\n3;5;5;5;3;1;wall;#\n5;5;3;3;3;1;wall;#\n"
    "obstacle;9;2;2;fence;#\n2;2;2.5;2;1;1;w;#\n4;2;4.5;2;1;1;w;#\n";

Finding finding_in_line_2() {
  Finding finding = make_finding(FindingCode::G104, "</script> & \"quotes\" \xff");
  finding.place = TextPlace{2, 3};
  finding.at = Point{1.0, 1.0};
  finding.obstacle = 7;
  return finding;
}

TEST(HtmlReport, HoldsFindingsWithTheLineTheyStandIn) {
  const auto page = written({{"a.txt", kText, {finding_in_line_2()}, {}, {{"k", "1", "said"}}},
                             {"b.txt", {}, {}, "no such file"}});
  const auto found = blocks(page, "class=\"found\"");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]["path"], "a.txt");
  EXPECT_EQ(found[0]["verdict"], "fail");
  EXPECT_EQ(found[0]["sections"][0]["line"], "said");
  EXPECT_EQ(found[0]["findings"][0]["code"], "G104");
  EXPECT_TRUE(found[0]["findings"][0]["excerpt"].get<std::string>().starts_with("  obstacle;7;"));
  EXPECT_EQ(found[1]["unreadable"], "no such file");
  const auto words = blocks(page, "id=\"page\"");
  ASSERT_EQ(words.size(), 1U);
  EXPECT_EQ(words[0]["summary"], "2 maps: 0 fit, 2 not");
  EXPECT_EQ(words[0]["codes"]["G104"]["name"], "outline_self_intersection");
  EXPECT_NE(words[0]["codes"]["G104"]["page"].get<std::string>().find("# G104"), std::string::npos);
}

TEST(HtmlReport, LetsNoTextOfAMapBecomeMarkup) {
  const auto page = written({{"</script>.txt", kText, {finding_in_line_2()}, {}}});
  // Two of its own, and three blocks of data.
  EXPECT_EQ(count(page, "</script"), 5U);
  EXPECT_EQ(count(page, "<script"), 5U);
  EXPECT_EQ(count(page, "<!--"), 0U);
  EXPECT_EQ(blocks(page, "class=\"scene\"")[0]["texts"][0], "</script><script>alert(1)</script>");
  EXPECT_EQ(blocks(page, "class=\"found\"")[0]["path"], "</script>.txt");
}

TEST(HtmlReport, NamesNothingThatABrowserWouldLoad) {
  const auto page = written({});
  EXPECT_FALSE(std::regex_search(page, std::regex("(https?:|\\bsrc=|\\bhref=|@import|url\\()")));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_FALSE(std::regex_search(page, std::regex("unsafe-inline|unsafe-eval|innerHTML")));
}

TEST(Scene, JoinsSegmentsAndSharesWhatIsEqual) {
  const Map map = read_map(std::string(kText)).map;
  SceneWriter writer(map.border, kind_layers());
  add_map(writer, map);
  const auto scene = Json::parse(writer.json());
  EXPECT_EQ(scene["border"], Json::parse("[0,10,10,0]"));
  const auto& solid = scene["obstacles"][0];
  EXPECT_EQ(solid[1], 7);
  EXPECT_EQ(scene["layers"][solid[0].get<std::size_t>()]["name"], "building");
  EXPECT_EQ(solid[4], Json::parse("[[1,1,9,1,9,9,1,9,1,1]]"));
  EXPECT_EQ(solid[5], 1);
  EXPECT_EQ(solid[6], Json::parse("[3,3,3,2]"));
  EXPECT_EQ(solid[7], Json::parse("[1,1,0,1]"));
  EXPECT_EQ(scene["texts"][solid[8][0].get<std::size_t>()], "<!--");
  EXPECT_EQ(scene["obstacles"][1][6], 3);
  EXPECT_EQ(scene["holes"], Json::parse("[[1,0]]"));
  const auto& fence = scene["obstacles"][2];
  EXPECT_EQ(fence[4], Json::parse("[[2,2,2.5,2],[4,2,4.5,2]]"));
  EXPECT_EQ(fence[5], 0);
}

TEST(Scene, FillsTheAreaAroundSteps) {
  Obstacle stairs{1, ShapeType::kStairs, {}, {}};
  stairs.segments = {{{0, 0}, {4, 0}, 0.2, InOut::kOutdoor, {}},
                     {{0, 1}, {4, 1}, 0.4, InOut::kOutdoor, {}},
                     {{4, 2}, {0, 2}, 0.0, InOut::kOutdoor, {}}};
  SceneWriter writer({0, 9, 9, 0}, kind_layers());
  writer.obstacle(stairs, 0, {{"moved", "1 m \"east\""}});
  writer.line(0, std::vector<Point>{{0, 0}, {1, 2}}, true);
  writer.box(0, {1, 2, 3, 4});
  writer.dot(0, {5, 6});
  const auto scene = Json::parse(writer.json());
  EXPECT_EQ(scene["obstacles"][0][5], Json::parse("[0,0,4,0,4,2,0,2]"));
  EXPECT_EQ(scene["obstacles"][0][9], Json::parse(R"([["moved", "1 m \"east\""]])"));
  EXPECT_EQ(scene["marks"], Json::parse(R"([{"layer":0,"line":[0,0,1,2],"arrow":true},
                                            {"layer":0,"box":[1,2,3,4]},{"layer":0,"dot":[5,6]}])"));
}

}  // namespace
}  // namespace mapwright::validators
