// SARIF, JUnit XML and GitHub annotations: what programs of others read.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "mapcore/text/reader.hpp"
#include "validators/check_pages.hpp"
#include "validators/fingerprint.hpp"
#include "validators/report/report.hpp"
#include "validators/report/source_lines.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {
namespace {

using nlohmann::json;

constexpr std::string_view kMap =
    "border;0;10;10;0;#\n"
    "obstacle;7;1;9;caf\u00e9;#\n"
    "2;2;6;6;3;1;wall;#\n"
    "6;6;6;2;3;1;wall;#\n"
    "6;2;2;6;3;1;wall;#\n"
    "2;6;2;2;3;1;wall;#\n"
    "obstacle;8;2;1; ;#\n"
    "8;8;9;9;3;1;wall;#\n";

std::string written(std::string_view format, const std::vector<MapReport>& maps,
                    const ReportOptions& options = {}) {
  std::ostringstream out;
  const auto writer = find_report_format(format)->make(out, options);
  for (const auto& map : maps) writer->map(map);
  writer->finish();
  return out.str();
}

struct Validated {
  MapDocument document;
  std::vector<Finding> findings;

  MapReport report(std::string_view path) const {
    MapReport report{path, document.text, findings, {}};
    report.names = fingerprints(document, findings);
    return report;
  }
};

Validated validated(std::string text) {
  Validated map{read_map(std::move(text)), {}};
  map.findings = validate(map.document);
  return map;
}

json sarif_run(const std::vector<MapReport>& maps) {
  return json::parse(written("sarif", maps))["runs"][0];
}

MapReport unreadable_report() {
  return {"b.txt", {}, {}, "b.txt: no such file"};
}

TEST(SarifReport, NamesRuleRegionAndObstacle) {
  const auto map = validated(std::string(kMap));
  const json run = sarif_run({map.report("maps/my map.txt")});
  EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
  ASSERT_EQ(run["results"].size(), 3U);
  const json& crossing = run["results"][1];
  EXPECT_EQ(crossing["ruleId"], "G104");
  EXPECT_EQ(crossing["level"], "error");
  EXPECT_EQ(crossing["message"]["text"], map.findings[1].message);
  const json& location = crossing["locations"][0];
  EXPECT_EQ(location["physicalLocation"]["artifactLocation"],
            (json{{"uri", "maps/my%20map.txt"}, {"index", 0}}));
  EXPECT_EQ(location["physicalLocation"]["region"],
            json::parse(R"({"startLine":5,"startColumn":1,"endColumn":2,"snippet":{"text":"6"}})"));
  EXPECT_EQ(location["logicalLocations"][0]["fullyQualifiedName"], "obstacle 7/segment 3");
  EXPECT_EQ(crossing["properties"]["geometry"]["points"], json::parse("[[4,4]]"));
  const auto rule = crossing["ruleIndex"].get<std::size_t>();
  EXPECT_EQ(run["tool"]["driver"]["rules"][rule]["id"], "G104");
}

TEST(SarifReport, ExplainsTheRulesThatAreBrokenOnceEach) {
  const auto map = validated(std::string(kMap));
  const json run = sarif_run({map.report("a.txt"), map.report("b.txt")});
  const json& rules = run["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), 3U);
  for (const json& rule : rules) {
    const auto code = finding_code(rule["id"].get<std::string>()).value();
    EXPECT_EQ(rule["help"]["markdown"], check_page(code));
    EXPECT_EQ(rule["defaultConfiguration"]["level"], to_string(finding_type(code).severity));
    EXPECT_NE(rule["helpUri"].get<std::string>().find(rule["id"]), std::string::npos);
  }
  EXPECT_EQ(rules[1]["name"], "OutlineSelfIntersection");
  EXPECT_EQ(run["results"].size(), 6U);
  EXPECT_EQ(run["artifacts"].size(), 2U);
}

TEST(SarifReport, CarriesTheFix) {
  const auto map = validated(std::string(kMap));
  const json change = sarif_run({map.report("a.txt")})["results"][0]["fixes"][0]["artifactChanges"];
  EXPECT_EQ(change[0]["artifactLocation"]["uri"], "a.txt");
  EXPECT_EQ(change[0]["replacements"], json::parse(R"([{
    "deletedRegion": {"startLine": 2, "startColumn": 14, "endLine": 2, "endColumn": 15},
    "insertedContent": {"text": "4"}}])"));
}

TEST(SarifReport, KeepsFingerprintsWhenLinesMove) {
  const auto before = validated(std::string(kMap));
  std::string text(kMap);
  text.insert(text.find("obstacle;8"), "\n\n\n");
  const auto after = validated(text);
  ASSERT_NE(before.findings[2].place, after.findings[2].place);
  const json old_results = sarif_run({before.report("a.txt")})["results"];
  const json new_results = sarif_run({after.report("a.txt")})["results"];
  for (std::size_t i = 0; i < old_results.size(); ++i) {
    EXPECT_EQ(old_results[i]["partialFingerprints"].size(), 2U);
    EXPECT_EQ(old_results[i]["partialFingerprints"], new_results[i]["partialFingerprints"]);
  }
}

TEST(SarifReport, TellsOfMapsThatCannotBeRead) {
  const json run = sarif_run({unreadable_report()});
  EXPECT_EQ(run["results"], json::array());
  EXPECT_EQ(run["invocations"][0]["executionSuccessful"], false);
  EXPECT_EQ(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"],
            "b.txt: no such file");
  EXPECT_EQ(sarif_run({})["invocations"][0]["executionSuccessful"], true);
}

TEST(SarifReport, WritesPathsAsUris) {
  const auto uri = [](std::string_view path) {
    return sarif_run({{path, {}, {}, {}}})["artifacts"][0]["location"]["uri"];
  };
  EXPECT_EQ(uri("/srv/a.txt"), "file:///srv/a.txt");
  EXPECT_EQ(uri("a:b %#?.txt"), "a%3Ab%20%25%23%3F.txt");
  EXPECT_EQ(uri("caf\u00e9"), "caf%C3%A9");
  EXPECT_EQ(uri("<stdin>"), "%3Cstdin%3E");
}

TEST(SarifReport, DoublesBracesAndSurvivesBytesThatAreNoText) {
  const Finding finding = make_finding(FindingCode::S104, "holds {0} and \xff");
  const json run = sarif_run({{"a.txt", {}, {finding}, {}}});
  EXPECT_EQ(run["results"][0]["message"]["text"], "holds {{0}} and \uFFFD");
}

pugi::xml_node parsed(pugi::xml_document& document, const std::string& text) {
  const auto result = document.load_string(text.c_str(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << "\n" << text;
  return document.child("testsuites");
}

TEST(JunitReport, FailsATestForEachError) {
  const auto map = validated(std::string(kMap));
  pugi::xml_document document;
  const auto suites = parsed(document, written("junit", {map.report("a.txt")}));
  const auto suite = suites.child("testsuite");
  EXPECT_STREQ(suite.attribute("name").value(), "a.txt");
  EXPECT_STREQ(suite.attribute("tests").value(), "2");
  EXPECT_STREQ(suite.attribute("failures").value(), "2");
  EXPECT_STREQ(suite.attribute("errors").value(), "0");
  const auto test = suite.child("testcase").next_sibling("testcase");
  EXPECT_STREQ(test.attribute("name").value(),
               "G104 outline_self_intersection: obstacle 7, segment 3");
  EXPECT_STREQ(test.child("failure").attribute("type").value(), "G104");
  EXPECT_STREQ(test.child("failure").text().get(),
               "a.txt:5:1: error: segment 3 of obstacle 7 crosses segment 1 at (4, 4); put the "
               "corners in the order in which they follow [G104]\n  6;2;2;6;3;1;wall;#\n  ^\n");
  EXPECT_NE(std::string(suite.child("system-out").text().get()).find("a.txt:7:17: warning: "),
            std::string::npos);
}

TEST(JunitReport, PassesATestWhereThereIsNoError) {
  const auto map = validated("border;0;10;10;0;#\n");
  pugi::xml_document document;
  const auto suite = parsed(document, written("junit", {map.report("a.txt")})).child("testsuite");
  EXPECT_STREQ(suite.attribute("tests").value(), "1");
  EXPECT_STREQ(suite.attribute("failures").value(), "0");
  EXPECT_FALSE(suite.child("testcase").first_child());
}

TEST(JunitReport, HasAnErrorForAMapThatCannotBeRead) {
  pugi::xml_document document;
  const auto suite = parsed(document, written("junit", {unreadable_report()})).child("testsuite");
  EXPECT_STREQ(suite.attribute("errors").value(), "1");
  EXPECT_STREQ(suite.child("testcase").child("error").attribute("message").value(),
               "b.txt: no such file");
}

TEST(JunitReport, ReplacesWhatXmlCannotHold) {
  const Finding finding = make_finding(FindingCode::F102, "<&\"> \x01 \xff \uFFFE caf\u00e9");
  const std::string text = written("junit", {{"a&b.txt", {}, {finding}, {}}});
  pugi::xml_document document;
  const auto failure = parsed(document, text).child("testsuite").child("testcase").child("failure");
  EXPECT_STREQ(failure.attribute("message").value(), "<&\"> \uFFFD \uFFFD \uFFFD caf\u00e9");
  EXPECT_EQ(text.find("&#0"), std::string::npos);
}

TEST(JunitReport, OfNoMapsIsStillADocument) {
  pugi::xml_document document;
  EXPECT_TRUE(parsed(document, written("junit", {})));
}

TEST(GithubReport, WritesAnAnnotationEach) {
  const auto map = validated("border;0;10;10;0;#\nobstacle;8;2;1; ;#\n8;8;8;8;3;1;wall;#\n");
  Finding note = make_finding(FindingCode::C208, "nothing");
  EXPECT_EQ(
      written("github", {map.report("maps/a.txt"), {"b.txt", {}, {note}, {}}, unreadable_report()}),
      "::warning file=maps/a.txt,line=2,col=17,title=S103 empty_semantic::obstacle 8 does "
      "not say what it is; write labels such as building or column\n"
      "::error file=maps/a.txt,line=3,col=1,title=G103 zero_length_segment::segment 1 of "
      "obstacle 8 begins and ends at (8, 8); remove it and count it off\n"
      "::notice file=b.txt,title=C208 ignored_by_rule::nothing\n"
      "::error file=b.txt,title=unreadable map::b.txt: no such file\n");
}

TEST(GithubReport, EscapesWhatSeparates) {
  const Finding finding = make_finding(FindingCode::C101, "100 %, a:b\r\n::error::c");
  EXPECT_EQ(written("github", {{"a,b:c%\n.txt", {}, {finding}, {}}}),
            "::error file=a%2Cb%3Ac%25%0A.txt,title=C101 malformed_georeference::100 %25, "
            "a:b%0D%0A::error::c\n");
}

TEST(FieldEnd, StandsBehindTheField) {
  EXPECT_EQ(field_end("12.5;caf\u00e9;#", 1), 5U);
  EXPECT_EQ(field_end("12.5;caf\u00e9;#", 6), 10U);
  EXPECT_EQ(field_end("12.5;caf\u00e9;#", 10), 11U);
  EXPECT_EQ(field_end("ab", 2), 3U);
  EXPECT_EQ(field_end("ab", 3), 3U);
  EXPECT_EQ(field_end("", 1), 1U);
  EXPECT_EQ(field_end(std::string(500, 'x'), 7), 107U);
}

TEST(Columns, AreCharacters) {
  EXPECT_EQ(columns("a\u20acbc", 2, 4), "\u20acb");
  EXPECT_EQ(columns("abc", 3, 9), "c");
  EXPECT_EQ(columns("abc", 8, 9), "");
}

}  // namespace
}  // namespace mapwright::validators
