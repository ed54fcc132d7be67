#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/support/unified_diff.hpp"
#include "mapcore/random.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::run;
using test::TemporaryFolder;

// Two wrong counts, a gap of 4 mm.
constexpr const char* kBroken =
    "border;0;10;10;0;#\nobstacle;1;1;9;column;#\n2;2;4;2;3;1;wall;#\n4;2;4;4;3;1;wall;#\n"
    "4;4;2;2.004;3;1;wall;#\n";
constexpr const char* kRepaired =
    "border;0;10;10;0;#\nobstacle;1;1;3;column;#\n2;2;4;2;3;1;wall;#\n4;2;4;4;3;1;wall;#\n"
    "4;4;2;2;3;1;wall;#\n";

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(FixVerb, WritesTheRepairedMapAndSaysWhatItDid) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken), out = folder.path("out.txt");
  const auto result = run({"fix", map, "-o", out, "--except", "layout"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(read(out), kRepaired);
  EXPECT_EQ(read(map), kBroken);
  EXPECT_EQ(result.out,
            "repaired: obstacle 1: '3' written for '9' [F113]\n"
            "repaired: obstacle 1: 1 end joined, moved by 0.004 m [G105]\n"
            "1 obstacle moved, by at most 0.004 m\n");
}

TEST(FixVerb, WritesOverTheMapWhereAskedTo) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken);
  EXPECT_EQ(run({"fix", map, "--in-place", "--except", "layout"}).status, 0);
  EXPECT_EQ(read(map), kRepaired);
}

TEST(FixVerb, ShowsAUnifiedDiffAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken);
  const auto result = run({"fix", map, "--dry-run", "--only", "F113"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "--- " + map + "\n+++ " + map +
                            "\n@@ -1,5 +1,5 @@\n border;0;10;10;0;#\n"
                            "-obstacle;1;1;9;column;#\n+obstacle;1;1;3;column;#\n"
                            " 2;2;4;2;3;1;wall;#\n 4;2;4;4;3;1;wall;#\n 4;4;2;2.004;3;1;wall;#\n");
  EXPECT_NE(result.err.find("[G105]"), std::string::npos) << result.err;
  EXPECT_EQ(read(map), kBroken);
}

TEST(FixVerb, AnswersAsJson) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken);
  const auto result =
      run({"fix", map, "-o", folder.path("o.txt"), "--format", "json", "--only", "G105,layout"});
  EXPECT_EQ(result.status, 1);
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["schema"], "mapwright.fix/1");
  EXPECT_EQ(answer["verdict"], "fail");
  EXPECT_EQ(answer["repairs"][0]["code"], "G105");
  EXPECT_EQ(answer["repairs"][1]["code"], "layout");
  EXPECT_EQ(answer["moved"][0]["obstacle"], 1);
  EXPECT_EQ(answer["findings"][0]["code"], "F113");
}

TEST(FixVerb, GoesByTheConfiguration) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken);
  folder.file(".mapwright.yaml", "suppressions: [{code: F113, reason: x}]\n");
  EXPECT_EQ(run({"fix", map, "--dry-run", "--except", "F113"}).status, 0);
}

TEST(FixVerb, RefusesWhatMakesNoSense) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.txt", kBroken);
  EXPECT_EQ(run({"fix", map}).status, 2);
  EXPECT_EQ(run({"fix", map, "--dry-run", "--in-place"}).status, 2);
  EXPECT_EQ(run({"fix", "-", "--in-place"}).status, 2);
  EXPECT_EQ(run({"fix", map, "-o", "-", "--format", "json"}).status, 2);
  EXPECT_EQ(run({"fix", map, "--dry-run", "--only", "S101"}).status, 2);
  EXPECT_EQ(run({"fix", map, "--dry-run", "--snap", "-1"}).status, 2);
  EXPECT_EQ(run({"fix", folder.path("none.txt"), "--dry-run"}).status, 3);
}

TEST(FixVerb, RepairsTheSampleWithSlipsAsFarAsItIsSafe) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out.txt");
  const std::string sample = test::project_file("samples/broken/square_broken.txt").string();
  const auto first = run({"fix", sample, "-o", out, "--format", "json"});
  const json answer = json::parse(first.out);
  EXPECT_GT(answer["repairs"].size(), 2U);
  EXPECT_LT(answer["findings"].size(), answer["findings_before"].get<std::size_t>());
  const auto second = run({"fix", out, "--dry-run"});
  EXPECT_EQ(second.out, "");
  EXPECT_EQ(second.status, first.status);
}

using cli::unified_diff;

TEST(UnifiedDiff, IsEmptyForEqualTexts) {
  EXPECT_EQ(unified_diff("a\nb\n", "a\nb\n", "p", "q"), "");
}

TEST(UnifiedDiff, HasThreeLinesOfContextAndSeveralHunks) {
  std::string before, after;
  for (int i = 1; i <= 30; ++i) {
    before += std::to_string(i) + "\n";
    if (i != 5) after += (i == 25 ? "x" : std::to_string(i)) + std::string("\n");
  }
  EXPECT_EQ(unified_diff(before, after, "p", "q"),
            "--- p\n+++ q\n@@ -2,7 +2,6 @@\n 2\n 3\n 4\n-5\n 6\n 7\n 8\n"
            "@@ -22,7 +21,7 @@\n 22\n 23\n 24\n-25\n+x\n 26\n 27\n 28\n");
}

TEST(UnifiedDiff, MarksAMissingLastLineBreak) {
  EXPECT_EQ(unified_diff("a\nb", "a\nb\n", "p", "q"),
            "--- p\n+++ q\n@@ -1,2 +1,2 @@\n a\n-b\n\\ No newline at end of file\n+b\n");
  EXPECT_EQ(unified_diff("", "a\n", "p", "q"), "--- p\n+++ q\n@@ -0,0 +1 @@\n+a\n");
  EXPECT_EQ(unified_diff("a\n", "", "p", "q"), "--- p\n+++ q\n@@ -1 +0,0 @@\n-a\n");
}

// The text after a diff, by its own rules: what `patch` does.
std::string patched(const std::string& before, const std::string& diff) {
  std::vector<std::string> lines;
  std::istringstream in(before);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::istringstream hunks(diff);
  std::string result;
  std::size_t at = 0;
  for (std::string line; std::getline(hunks, line);) {
    if (line.starts_with("---") || line.starts_with("+++")) continue;
    if (line.starts_with("@@")) {
      const std::string numbers = line.substr(4, line.find('+') - 5);
      std::size_t first = std::stoul(numbers);
      if (!numbers.ends_with(",0")) --first;
      while (at < first) result += lines[at++] + "\n";
      continue;
    }
    if (line[0] != '+') {
      EXPECT_EQ(lines.at(at), line.substr(1));
      ++at;
    }
    if (line[0] != '-') result += line.substr(1) + "\n";
  }
  while (at < lines.size()) result += lines[at++] + "\n";
  return result;
}

TEST(UnifiedDiff, LeadsFromOneTextToTheOther) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    std::string before, after;
    for (std::uint64_t i = random.below(60); i > 0; --i) {
      const std::string line = std::string(1, static_cast<char>('a' + random.below(4))) + "\n";
      if (random.below(8) != 0) before += line;
      if (random.below(8) != 0) after += line;
    }
    EXPECT_EQ(patched(before, unified_diff(before, after, "p", "q")), after) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mapwright
