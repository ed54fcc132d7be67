// Many maps through `check`: which ones, each in a process of its own, resumed after a kill.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/support/campus_generator.hpp"
#include "tests/cli/map_folder.hpp"
#include "tests/cli/process.hpp"
#include "tests/cli/processes.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

bool has_finding(const Json& map, const std::string& code) {
  const auto& findings = map["findings"];
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Json& finding) { return finding["code"] == code; });
}

class CheckBatch : public testing::Test {
 protected:
  std::vector<std::string> quick(std::vector<std::string> options) const {
    options.insert(options.begin(), "check");
    options.insert(options.end(), {"--trials", "0", "--plans", "3"});
    return options;
  }
  ProgramRun check(const std::vector<std::string>& options) const { return run(quick(options)); }

  std::vector<std::string> names(std::vector<std::string> options) const {
    options.insert(options.end(), {"--format", "json"});
    std::vector<std::string> found;
    const Json answer = Json::parse(check(options).out);
    for (const auto& map : answer["maps"]) {
      found.push_back(fs::path(map["path"].get<std::string>()).filename().string());
    }
    return found;
  }

  // One map that takes for ever (its localization runs) between two that do not.
  std::vector<std::string> endless(std::vector<std::string> options) const {
    const std::vector<std::string> more{"check",
                                        folder_.file("a.txt", full_map_text()),
                                        folder_.file("b.txt", fit_map_text()),
                                        folder_.file("c.txt", full_map_text()),
                                        "--trials",
                                        "1000000",
                                        "--plans",
                                        "0",
                                        "--journal",
                                        journal_};
    options.insert(options.begin(), more.begin(), more.end());
    return options;
  }

  std::size_t journal_lines() const {
    const std::string text = text_of(journal_);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  TemporaryFolder folder_;
  std::string journal_ = folder_.path("journal");
};

using Names = std::vector<std::string>;

TEST_F(CheckBatch, MapsComeByPathAndOnce) {
  const std::string maps = make_map_folder(folder_, 3);
  const Names all{"m00.txt", "m01.txt", "m02.txt"};
  EXPECT_EQ(names({maps}), all);
  EXPECT_EQ(names({maps + "/m02.txt", maps, maps + "/./m01.txt", maps + "//"}), all);
}

TEST_F(CheckBatch, SubfoldersWhenAskedHiddenFilesNever) {
  for (const char* name : {"top/b.txt", "top/sub/a.txt", "top/sub/deep/c.txt", "top/.b.x7Kd2f.txt",
                           "top/.git/d.txt", "top/readme.md"}) {
    fs::create_directories(fs::path(folder_.path(name)).parent_path());
    folder_.file(name, fit_map_text());
  }
  fs::create_directory_symlink(folder_.path("top"), folder_.path("top/sub/circle"));
  EXPECT_EQ(names({folder_.path("top")}), Names{"b.txt"});
  EXPECT_EQ(names({folder_.path("top"), "--recursive"}), (Names{"b.txt", "a.txt", "c.txt"}));
  fs::remove(folder_.path("top/b.txt"));
  const ProgramRun none = check({folder_.path("top")});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("holds no map (*.txt); --recursive"), std::string::npos) << none.err;
}

TEST_F(CheckBatch, AMapThatComesOrGoesMovesNoOtherToAnotherShard) {
  const std::string maps = make_map_folder(folder_, 12);
  std::map<std::string, int> shard_of;
  for (int part = 1; part <= 3; ++part) {
    for (const auto& name : names({maps, "--shard", std::to_string(part) + "/3"})) {
      EXPECT_TRUE(shard_of.emplace(name, part).second) << name;
    }
  }
  EXPECT_EQ(shard_of.size(), 12U);
  fs::remove(maps + "/m00.txt");
  folder_.file("maps/aaa.txt", fit_map_text());
  fs::rename(maps, folder_.path("elsewhere"));  // the path within the folder counts
  for (int part = 1; part <= 3; ++part) {
    for (const auto& name :
         names({folder_.path("elsewhere"), "--shard", std::to_string(part) + "/3"})) {
      if (name == "aaa.txt") continue;
      EXPECT_EQ(shard_of.at(name), part) << name;
    }
  }
}

TEST_F(CheckBatch, SameBytesForAnyNumberOfJobs) {
  const std::string maps = make_map_folder(folder_, 10);
  for (const char* format : {"text", "json"}) {
    const ProgramRun one = check({maps, "--format", format});
    EXPECT_EQ(one.status, 1);
    for (const char* jobs : {"2", "7", "0"}) {
      EXPECT_EQ(check({maps, "--format", format, "--jobs", jobs}).out, one.out) << jobs;
    }
  }
}

TEST_F(CheckBatch, TextEndsWithATableOfVerdictsAndCodes) {
  const std::string maps = make_map_folder(folder_, 7);
  const std::string out = check({maps, maps + "/gone.txt"}).out;
  EXPECT_NE(out.find("\nverdict          maps\npass "), std::string::npos) << out;
  EXPECT_NE(out.find("\nunreadable          1\n"), std::string::npos) << out;
  EXPECT_NE(out.find("\nN101         2       2  no_free_space\n"), std::string::npos) << out;
  EXPECT_EQ(check({maps + "/m00.txt"}).out.find("verdict    "), std::string::npos);
}

TEST_F(CheckBatch, AHangCostsOneMap) {
  const ProgramRun run = run_process(folder_, endless({"--time-limit", "2", "--format", "json"}));
  EXPECT_EQ(run.status, 1) << run.err;
  const Json maps = Json::parse(run.out)["maps"];
  EXPECT_TRUE(has_finding(maps[0], "N101"));
  EXPECT_EQ(maps[1]["verdict"], "fail");
  EXPECT_EQ(maps[1]["interrupted"], "time limit");
  EXPECT_NE(run.err.find("longer than 2 s and was stopped; allow it more (--time-limit)"),
            std::string::npos)
      << run.err;
  EXPECT_TRUE(has_finding(maps[2], "N101"));
  EXPECT_NE(run.err.find("3 maps: 0 fit, 2 not, 1 over a limit"), std::string::npos) << run.err;
}

TEST_F(CheckBatch, ACrashCostsOneMapAndIsNamed) {
  const pid_t program = start_process(folder_, endless({"--format", "json"}));
  ASSERT_TRUE(wait_until([&] { return journal_lines() == 1; }));
  ASSERT_TRUE(wait_until([&] { return children_of(program).size() == 1; }));
  ::kill(children_of(program).front(), SIGSEGV);
  const ProgramRun run = wait_for_process(folder_, program);
  EXPECT_EQ(run.status, 5) << run.err;
  const Json maps = Json::parse(run.out)["maps"];
  EXPECT_EQ(maps[1]["interrupted"], "crash");
  EXPECT_NE(run.err.find("b.txt: its check crashed: SIGSEGV"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("please report it with the map"), std::string::npos) << run.err;
  EXPECT_TRUE(has_finding(maps[2], "N101"));
  EXPECT_EQ(journal_lines(), 2U);
}

TEST_F(CheckBatch, TooMuchMemoryCostsOneMap) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer takes terabytes of addresses";
#endif
  const std::string big = folder_.file("big.txt", format_map(generate_campus(bench::kCampus1km)));
  const std::string good = folder_.file("good.txt", fit_map_text());
  const ProgramRun run = check({big, good, "--memory-limit", "5", "--format", "json"});
  EXPECT_EQ(run.status, 1);
  const Json maps = Json::parse(run.out)["maps"];
  EXPECT_EQ(maps[0]["interrupted"], "memory limit");
  EXPECT_EQ(maps[1]["verdict"], "pass");
  EXPECT_NE(run.err.find("needs more than 5 MB of memory; allow it more (--memory-limit)"),
            std::string::npos)
      << run.err;
}

TEST_F(CheckBatch, AnyEndOfTheProgramTakesItsWorkersAlong) {
  const std::string report = folder_.path("report.json");
  for (const int signal : {SIGKILL, SIGTERM, SIGINT}) {
    fs::remove(journal_);
    const pid_t program = start_process(folder_, endless({"-o", report, "--jobs", "3"}));
    ASSERT_TRUE(wait_until([&] { return journal_lines() == 2; }));
    const auto workers = children_of(program);
    ASSERT_EQ(workers.size(), 1U);
    ::kill(program, signal);
    EXPECT_EQ(wait_for_process(folder_, program).status, 128 + signal);
    EXPECT_TRUE(wait_until([&] { return !is_alive(workers.front()); })) << signal;
    EXPECT_FALSE(fs::exists(report));
  }
}

// Kills the run again and again, at random, until it comes to its end.
TEST_F(CheckBatch, KilledAndResumedItGivesTheSameReport) {
  const std::string maps = make_map_folder(folder_, 20);
  const std::string expected = check({maps, "--format", "json"}).out;
  const std::string report = folder_.path("report.json");
  const auto options = quick(
      {maps, "--format", "json", "-o", report, "--journal", journal_, "--resume", "--jobs", "2"});
  int kills = 0;
  for (std::size_t wanted = 3; wanted < 18; wanted += 5) {
    const pid_t program = start_process(folder_, options);
    ASSERT_TRUE(wait_until([&] { return journal_lines() >= wanted || !is_alive(program); }));
    ::kill(program, SIGKILL);
    kills += wait_for_process(folder_, program).status == 128 + SIGKILL ? 1 : 0;
    std::ofstream(journal_, std::ios::app) << "{\"settings\":\"torn";  // as if in the middle
  }
  EXPECT_GT(kills, 0);
  const ProgramRun last = run_process(folder_, options);
  EXPECT_EQ(last.status, 1) << last.err;
  EXPECT_NE(last.err.find(" of 20 maps are done already"), std::string::npos) << last.err;
  EXPECT_EQ(text_of(report), expected);
}

TEST_F(CheckBatch, AJournalIsAFile) {
  const ProgramRun refused =
      run_process(folder_, {"check", folder_.file("a.txt", full_map_text()), "--journal", "-"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--journal: name a file"), std::string::npos) << refused.err;
}

TEST_F(CheckBatch, ResumeChecksAgainWhatChanged) {
  const std::string maps = make_map_folder(folder_, 6);
  const auto resumed = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {maps, "--journal", journal_, "--resume"});
    const ProgramRun run = check(options);
    EXPECT_EQ(run.out, check({options.begin() + 4, options.end()}).out);
    return run;
  };
  resumed({maps});
  EXPECT_EQ(journal_lines(), 6U);
  EXPECT_NE(resumed({maps}).err.find("6 of 6 maps are done already"), std::string::npos);
  EXPECT_EQ(journal_lines(), 6U);

  folder_.file("maps/m00.txt", full_map_text());
  EXPECT_NE(resumed({maps}).out.find("m00.txt: verdict: fail"), std::string::npos);
  EXPECT_EQ(journal_lines(), 7U);
  folder_.file("maps/m01.georef.json", "{}");  // a sidecar is part of its map
  EXPECT_NE(resumed({maps}).out.find("[C101]"), std::string::npos);
  EXPECT_EQ(journal_lines(), 8U);
  resumed({maps, "--seed", "2"});  // other options: all again
  EXPECT_EQ(journal_lines(), 14U);
  folder_.file("maps/.mapwright.yaml", "checks: {S103: off}\n");
  resumed({maps});  // another configuration: all again
  EXPECT_EQ(journal_lines(), 20U);
  resumed({maps, "--time-limit", "100"});  // another limit changes no finished map
  EXPECT_EQ(journal_lines(), 20U);
}

TEST_F(CheckBatch, JournalsAreNotOverwrittenOrShared) {
  const std::string map = folder_.file("map.txt", fit_map_text());
  EXPECT_EQ(check({map, "--journal", journal_}).status, 0);
  const ProgramRun again = check({map, "--journal", journal_});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("--resume goes on with it"), std::string::npos) << again.err;
  EXPECT_EQ(check({map, "--resume"}).status, 2);
  EXPECT_EQ(check({map, "--journal", folder_.path("none/journal")}).status, 4);

  fs::remove(journal_);
  const pid_t program = start_process(folder_, endless({}));
  ASSERT_TRUE(wait_until([&] { return journal_lines() == 1; }));
  const ProgramRun second = check({map, "--journal", journal_, "--resume"});
  ::kill(program, SIGKILL);
  wait_for_process(folder_, program);
  EXPECT_EQ(second.status, 4);
  EXPECT_NE(second.err.find("another run that still goes on"), std::string::npos) << second.err;
}

TEST_F(CheckBatch, StandardInputIsAMapLikeOthers) {
  ProcessOptions options;
  options.standard_input = full_map_text();
  const std::string map = folder_.file("map.txt", fit_map_text());
  const ProgramRun run = run_process(folder_, quick({"-", map, "--format", "json"}), options);
  EXPECT_EQ(run.status, 1);
  const Json maps = Json::parse(run.out)["maps"];
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[1]["path"], "<stdin>");
  EXPECT_TRUE(has_finding(maps[1], "N101"));
}

}  // namespace
}  // namespace mapwright
