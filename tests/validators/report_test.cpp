#include "validators/report/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "validators/report/source_lines.hpp"
#include "validators/report/text.hpp"

namespace mapwright::validators {
namespace {

constexpr std::string_view kText = "border;0;9;9;0;#\nobstacle;1;1;4;caf\u00e9,x;#\n";

Finding sample_finding() {
  Finding finding = make_finding(FindingCode::G104, "segment 3 crosses segment 1");
  finding.place = TextPlace{2, 21};
  finding.at = Point{34.65, 41.02};
  finding.obstacle = 26;
  finding.segment = 3;
  return finding;
}

std::string written(std::string_view format, const std::vector<MapReport>& maps,
                    const ReportOptions& options = {}) {
  std::ostringstream out;
  const auto writer = find_report_format(format)->make(out, options);
  for (const auto& map : maps) writer->map(map);
  writer->finish();
  return out.str();
}

TEST(TextReport, ShowsLineAndCaret) {
  EXPECT_EQ(written("text", {{"a.txt", kText, {sample_finding()}, {}}}),
            "a.txt:2:21: error: segment 3 crosses segment 1 [G104]\n"
            "  obstacle;1;1;4;caf\u00e9,x;#\n"
            "                      ^\n");
}

TEST(TextReport, PaintsOnlyWhenAskedTo) {
  const MapReport report{"a.txt", kText, {sample_finding()}, {}};
  EXPECT_EQ(written("text", {report}).find('\033'), std::string::npos);
  EXPECT_NE(written("text", {report}, {"validate", true}).find("\033[1;31merror"),
            std::string::npos);
}

TEST(TextReport, NamesMapsThatCannotBeRead) {
  EXPECT_EQ(written("text", {{"a.txt", {}, {}, "no such file"}}), "a.txt: error: no such file\n");
}

TEST(JsonReport, HasTheKeysScriptsRelyOn) {
  Finding bare = make_finding(FindingCode::C101, "a \"quote\" and \xff");
  const auto text = written("json", {{"a.txt", kText, {sample_finding(), bare}, {}},
                                     {"b.txt", kText, {}, {}},
                                     {"c.txt", {}, {}, "no such file"}});
  EXPECT_TRUE(text.starts_with("{\n  \"schema\": \"mapwright.validate/1\",\n  \"maps\": ["));
  const auto json = nlohmann::json::parse(text);
  ASSERT_EQ(json["maps"].size(), 3U);
  EXPECT_EQ(json["maps"][0]["verdict"], "fail");
  EXPECT_EQ(json["maps"][1]["verdict"], "pass");
  EXPECT_EQ(json["maps"][1]["findings"], nlohmann::json::array());
  EXPECT_EQ(json["maps"][2]["verdict"], "fail");
  EXPECT_EQ(json["maps"][2]["unreadable"], "no such file");
  EXPECT_EQ(json["maps"][0]["findings"][0],
            nlohmann::json::parse(R"({"code":"G104","severity":"error",
              "message":"segment 3 crosses segment 1","line":2,"column":21,"x":34.65,"y":41.02,
              "obstacle":26,"segment":3})"));
  for (const auto* key : {"line", "column", "x", "y", "obstacle", "segment"}) {
    EXPECT_TRUE(json["maps"][0]["findings"][1].at(key).is_null()) << key;
  }
}

TEST(JsonReport, OfNoMapsIsStillADocument) {
  EXPECT_EQ(nlohmann::json::parse(written("json", {}))["maps"], nlohmann::json::array());
}

TEST(ReportFormats, AreFoundByName) {
  EXPECT_EQ(find_report_format("xml"), nullptr);
  for (const auto& format : report_formats()) EXPECT_EQ(find_report_format(format.name), &format);
}

TEST(SourceLines, AreFoundInAnyOrder) {
  SourceLines lines("\xEF\xBB\xBFone\r\ntwo\n\nfour");
  EXPECT_EQ(lines.line(4), "four");
  EXPECT_EQ(lines.line(1), "one");
  EXPECT_EQ(lines.line(2), "two");
  EXPECT_EQ(lines.line(3), "");
  EXPECT_EQ(lines.line(9), "");
}

TEST(Excerpt, OfALongLineShowsThePartAroundTheCaret) {
  std::string line(1000, 'a');
  line[499] = 'X';
  const std::string shown = excerpt(line, 500);
  const auto caret = shown.substr(shown.find('\n') + 1).find('^');
  EXPECT_LT(shown.size(), 200U);
  EXPECT_EQ(shown[caret], 'X');
}

TEST(Excerpt, KeepsTheCaretUnderItsCharacter) {
  EXPECT_EQ(excerpt("a\tb", 3), "  a b\n    ^\n");
  EXPECT_EQ(excerpt("", 1), "");
  EXPECT_EQ(excerpt("ab", 3), "  ab\n    ^\n");
}

}  // namespace
}  // namespace mapwright::validators
