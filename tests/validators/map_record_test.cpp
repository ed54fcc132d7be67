#include "validators/report/map_record.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace mapwright::validators {
namespace {

const std::string kText = "one\ntwo \xE9\xFF\r\nthree\n\nfive";

Finding quoting(std::size_t line, std::size_t column) {
  Finding finding = make_finding(FindingCode::F109, "'\xE9' is no number");
  finding.place = TextPlace{line, column};
  return finding;
}

// All that a finding can hold.
Finding full_finding() {
  Finding finding = quoting(2, 5);
  finding.severity = Severity::kNote;
  finding.at = Point{0.1, -1e-7};
  finding.obstacle = -12345678901234;
  finding.segment = 7;
  finding.geometry = {{{1, 2}}, {{{0.1, 0.2}, {3, 4}}}, {{{0, 0}, {1, 0}, {1, 1}}}};
  finding.fix = {{{2, 5}, {2, 6}, "\xE8"}, {{3, 1}, {3, 1}, ""}};
  finding.features = {{"a.gpkg", "caf\xE9", 12}};
  return finding;
}

MapReport full_report() {
  MapReport report{"maps/\xE9.txt", kText, {full_finding(), quoting(5, 1)}, {}, {}};
  report.sections = {{"planning", R"({"trials":3,"share":0.30000000000000004})", "planning: \xFF"},
                     {"", "", "verdict: pass"}};
  report.names = {{"1f", "2e"}, {"3d", "4c"}};
  report.suppressed = {{quoting(3, 2), {"5b", "6a"}, "site.yaml:3:5", "known \xFF"}};
  return report;
}

MapRecord there_and_back(const MapRecord& record) {
  const auto parsed = parse_record(record_json(record));
  EXPECT_TRUE(parsed) << parsed.error().message;
  return parsed ? *parsed : MapRecord{};
}

TEST(MapRecord, KeepsTheLinesThatFindingsName) {
  const MapRecord record = make_record(full_report(), "d1");
  EXPECT_EQ(record.lines,
            (std::vector<QuotedLine>{{2, "two \xE9\xFF"}, {3, "three"}, {5, "five"}}));
  EXPECT_EQ(record.quoted_text(), "\ntwo \xE9\xFF\nthree\n\nfive");
}

TEST(MapRecord, ComesBackFromJsonAsItWas) {
  const MapRecord record = make_record(full_report(), "d1");
  const MapRecord back = there_and_back(record);
  EXPECT_EQ(back.path, record.path);
  EXPECT_EQ(back.digest, "d1");
  EXPECT_EQ(back.findings, record.findings);
  EXPECT_EQ(back.lines, record.lines);
  EXPECT_EQ(back.names, record.names);
  EXPECT_EQ(back.suppressed, record.suppressed);
  ASSERT_EQ(back.sections.size(), 2U);
  EXPECT_EQ(back.sections[0].key, "planning");
  EXPECT_EQ(back.sections[0].json, record.sections[0].json);
  EXPECT_EQ(back.sections[0].line, record.sections[0].line);
  EXPECT_EQ(back.sections[1].json, "");
  EXPECT_EQ(back.sections[1].line, "verdict: pass");
  EXPECT_FALSE(back.unreadable);
}

TEST(MapRecord, WhatEndedACheckComesBackToo) {
  for (const auto kind : {Interruption::kNone, Interruption::kTimeLimit, Interruption::kMemoryLimit,
                          Interruption::kCrash}) {
    MapRecord record;
    record.path = "a.txt";
    record.unreadable = "a.txt: \xFF";
    record.interruption = kind;
    const MapRecord back = there_and_back(record);
    EXPECT_EQ(back.unreadable, record.unreadable);
    EXPECT_EQ(back.interruption, kind);
    EXPECT_FALSE(back.report({}).passes());
  }
}

TEST(MapRecord, ReportsAreWrittenFromItAsFromTheMap) {
  for (const char* format : {"text", "json", "sarif", "junit", "github"}) {
    const auto written = [&](const MapReport& report) {
      std::ostringstream out;
      const auto writer = find_report_format(format)->make(out, {});
      writer->map(report);
      writer->finish();
      return out.str();
    };
    const MapRecord record = there_and_back(make_record(full_report(), ""));
    const std::string quoted = record.quoted_text();
    EXPECT_EQ(written(record.report(quoted)), written(full_report())) << format;
  }
}

TEST(MapRecord, HasTheKeysOfTheContract) {
  const auto json = nlohmann::json::parse(record_json(make_record(full_report(), "")));
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["planning"]["trials"], 3);
  EXPECT_EQ(json["findings"][0]["code"], "F109");
  EXPECT_EQ(json["findings"][0]["segment"], 7);
}

TEST(MapRecord, RefusesWhatIsNone) {
  const std::string good = record_json(make_record(full_report(), ""));
  EXPECT_TRUE(parse_record(good));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"F109", "X109"},
                                                        {"\"note\"", "\"bad\""},
                                                        {"\"number\":5", "\"number\":2"},
                                                        {"\"digest\"", "\"d\""},
                                                        {"\"planning\"", "\"plan\""},
                                                        {"}", ""}}) {
    std::string bad = good;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_FALSE(parse_record(bad)) << bad;
  }
  EXPECT_FALSE(parse_record(""));
  EXPECT_FALSE(parse_record("[]"));
}

}  // namespace
}  // namespace mapwright::validators
