// Parts of a report, and the whole they make.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/support/findings_layers.hpp"
#include "tests/cli/map_folder.hpp"
#include "validators/report/report.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

class ReportMerge : public testing::Test {
 protected:
  ProgramRun check(Words options) const {
    options.insert(options.begin(), "check");
    options.insert(options.end(), {"--trials", "0", "--plans", "3"});
    return run(options);
  }

  std::string part(int i, int n, const std::string& name, const Words& more = {}) const {
    Words options{maps_,
                  "--format",
                  "json",
                  "-o",
                  folder_.path(name),
                  "--shard",
                  std::to_string(i) + "/" + std::to_string(n)};
    options.insert(options.end(), more.begin(), more.end());
    check(options);
    return folder_.path(name);
  }

  Words parts(int n) const {
    Words paths;
    for (int i = n; i >= 1; --i) {
      paths.push_back(part(i, n, "part-" + std::to_string(i) + "-of-" + std::to_string(n)));
    }
    return paths;
  }

  ProgramRun merge(Words words) const {
    words.insert(words.begin(), {"report", "merge"});
    return run(words);
  }

  void expect_refused(const Words& words, int status, const std::string& reason) const {
    const ProgramRun run = merge(words);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }

  TemporaryFolder folder_;
  std::string maps_ = make_map_folder(folder_, 12);
};

TEST_F(ReportMerge, GivesTheBytesOfOneRunInAnyFormatForAnyNumberOfParts) {
  std::filesystem::remove(maps_ + "/m05.txt");
  std::filesystem::create_symlink("nowhere", maps_ + "/m05.txt");  // cannot be read
  Words names;
  for (const auto& format : validators::report_formats()) names.emplace_back(format.name);
  for (const auto& format : cli::gis_report_formats()) names.emplace_back(format.name);
  for (const int n : {1, 3, 10}) {
    const Words files = parts(n);
    for (const auto& name : names) {
      const std::string whole = folder_.path("whole." + name);
      const std::string merged = folder_.path("merged." + name);
      EXPECT_EQ(check({maps_, "--format", name, "-o", whole}).status, 3);
      Words words = files;
      words.insert(words.end(), {"--format", name, "-o", merged});
      EXPECT_EQ(merge(words).status, 3);
      EXPECT_GT(text_of(whole).size(), 100U) << name;
      EXPECT_TRUE(text_of(merged) == text_of(whole)) << name << " of " << n << " parts";
    }
  }
}

// Which suppressions nobody needs is known when all parts are there.
TEST_F(ReportMerge, ConfigurationsAreJudgedByTheWhole) {
  folder_.file(".mapwright.yaml",
               "suppressions:\n"
               "  - {code: N101, reason: a depot, path: 'm01.txt'}\n"
               "  - {code: G101, reason: nobody needs this}\n"
               "  - {code: G102, reason: over, until: 2020-01-01}\n");
  const std::string whole = check({maps_, "--profile", "strict"}).out;
  EXPECT_NE(whole.find("suppression of G101 covers nothing"), std::string::npos) << whole;
  EXPECT_NE(whole.find("suppression of G102 held until"), std::string::npos) << whole;
  EXPECT_EQ(whole.find("suppression of N101"), std::string::npos) << whole;
  Words files;
  for (int i = 1; i <= 3; ++i) {
    files.push_back(part(i, 3, "part-" + std::to_string(i), {"--profile", "strict"}));
  }
  EXPECT_EQ(merge(files).out, whole);
  folder_.file(".mapwright.yaml", "checks: {S103: off}\n");
  files[0] = part(1, 3, "other", {"--profile", "strict"});
  expect_refused(files, 2, "--config is ");
}

// Formats that draw maps must not draw others than those that were checked.
TEST_F(ReportMerge, RefusesToDrawMapsThatHaveChanged) {
  const std::string all = part(1, 1, "all");
  folder_.file("maps/m00.txt", full_map_text());
  const std::string page = folder_.path("page.html");
  expect_refused({all, "--format", "html", "-o", page}, 3,
                 "m00.txt: has changed since it was checked");
  EXPECT_FALSE(std::filesystem::exists(page));
  EXPECT_EQ(merge({all, "--format", "sarif"}).status, 1);
}

TEST_F(ReportMerge, PartsAreJsonReports) {
  const Json answer = Json::parse(text_of(part(1, 1, "part")));
  EXPECT_EQ(answer["schema"], "mapwright.check/1");
  EXPECT_EQ(answer["shard"]["part"], 1);
  EXPECT_EQ(answer["shard"]["parts"], 1);
  EXPECT_EQ(answer["shard"]["maps"], 12);
  EXPECT_EQ(answer["shard"]["options"]["seed"], "1");
  ASSERT_EQ(answer["maps"].size(), 12U);
  EXPECT_EQ(answer["maps"][0]["verdict"], "pass");
  EXPECT_EQ(answer["maps"][0]["planning"]["trials"], 3);
}

TEST_F(ReportMerge, RefusesPartsThatMakeNoWhole) {
  const Words three = parts(3);
  expect_refused({three[0], three[2]}, 2, "of 3 parts these are missing: 2;");
  expect_refused({three[1]}, 2, "these are missing: 1 3;");
  expect_refused({three[0], three[1], three[2], three[1]}, 2, "part 2 is there twice: ");
  expect_refused({three[0], three[1], part(1, 2, "half")}, 2, "the number of parts is 3 in ");
}

TEST_F(ReportMerge, RefusesPartsOfDifferentRuns) {
  const std::string second = part(2, 2, "second");
  const auto first = [&](const Words& more) { return part(1, 2, "first", more); };
  EXPECT_EQ(merge({first({}), second}).status, 1);
  expect_refused({first({"--seed", "7"}), second}, 2, "--seed is 7 in " + folder_.path("first"));
  expect_refused({first({"--robot-radius", "0.4"}), second}, 2, "--robot-radius is 0.4 in ");
  expect_refused({first({"--time-limit", "5"}), second}, 2, "--time-limit is 5 in ");

  Json other = Json::parse(text_of(first({})));
  other["shard"]["program"] = "0.0.1";
  expect_refused({folder_.file("first", other.dump()), second}, 2,
                 "the program's version is 0.0.1 in ");

  folder_.file("maps/more.txt", fit_map_text());
  expect_refused({first({}), second}, 2, "the number of maps is 13 in ");
  std::filesystem::remove(maps_ + "/m00.txt");
  expect_refused({first({}), second}, 2, "the digest of their paths is ");
}

TEST_F(ReportMerge, RefusesWhatIsNoPart) {
  const std::string map = maps_ + "/m00.txt";
  expect_refused({map}, 3, "is no part of a report, or not all of it");
  expect_refused({folder_.path("gone")}, 3, "cannot be read");
  check({map, "--format", "json", "-o", folder_.path("report")});
  expect_refused({folder_.path("report")}, 3, "--shard i/n --format json");
  const std::string text = text_of(part(1, 1, "whole"));
  expect_refused({folder_.file("torn", text.substr(0, text.size() / 2))}, 3, "not all of it");
  Json fewer = Json::parse(text);
  fewer["maps"].erase(3);
  expect_refused({folder_.file("fewer", fewer.dump())}, 3, "hold 11 maps, but not the 12");
  Json unknown = Json::parse(text);
  unknown["maps"][1]["findings"][0]["code"] = "X999";
  expect_refused({folder_.file("unknown", unknown.dump())}, 3, "there is no finding X999");
}

TEST_F(ReportMerge, WrongUsage) {
  EXPECT_EQ(run({"report"}).status, 2);
  EXPECT_EQ(run({"report", "merge"}).status, 2);
  EXPECT_EQ(run({"report", "split", "x"}).status, 2);
  EXPECT_EQ(run({"report", "merge", "x", "--format", "xml"}).status, 2);
}

}  // namespace
}  // namespace mapwright
