#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/process.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using nlohmann::json;
using test::run;
using test::TemporaryFolder;

std::string box(int id, double x, double y, double size, const char* height = "3") {
  const auto point = [](double px, double py) {
    return std::to_string(px) + ";" + std::to_string(py) + ";";
  };
  const double corners[][2] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  std::string text = "obstacle;" + std::to_string(id) + ";1;4;building;#\n";
  for (int i = 0; i < 4; ++i) {
    const auto* a = corners[i];
    const auto* b = corners[(i + 1) % 4];
    text += point(a[0], a[1]) + point(b[0], b[1]) + height + ";1;wall;#\n";
  }
  return text;
}

// A wall across a yard of 20 m with a gap on its right.
std::string yard(double gap_m) {
  const std::string end = std::to_string(20.0 - gap_m);
  return "border;0;20;20;0;#\nobstacle;1;2;1;fence;#\n0;10;" + end + ";10;2;1;fence;#\n" +
         box(2, 3, 3, 2);
}

TEST(Diff, SaysNothingWhereNothingDiffers) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", yard(2.0));
  const auto result = run({"diff", a, folder.file("b.txt", yard(2.0))});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "");
}

TEST(Diff, OtherNumbersAreANoteAndNoDifference) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", "border;0;20;20;0;#\n" + box(1, 3, 3, 2) + box(2, 8, 8, 3));
  const auto b = folder.file("b.txt", "border;0;20;20;0;#\n" + box(7, 8, 8, 3) + box(9, 3, 3, 2));
  const auto result = run({"diff", a, b});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("renumbered 2 obstacles have another number only\n"),
            std::string::npos);
  const auto answer = json::parse(run({"diff", a, b, "--format", "json"}).out);
  EXPECT_EQ(answer["same"], true);
  EXPECT_EQ(answer["counts"]["renumbered"], 2);
  EXPECT_EQ(answer["obstacles"][0]["changes"], json::parse(R"(["renumbered"])"));
}

TEST(Diff, NamesEachKindOfChange) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", "border;0;40;40;0;#\n" + box(1, 3, 3, 2) + box(2, 10, 3, 2) +
                                          box(3, 20, 3, 2) + box(4, 30, 3, 2) + box(5, 3, 30, 1));
  const auto b =
      folder.file("b.txt", "border;0;50;40;0;#\n" + box(1, 3.3, 3.4, 2) + box(2, 10, 3, 2.5) +
                               box(3, 20, 3, 2, "4") + box(5, 3, 30, 1) + box(6, 20, 30, 4));
  const auto text = run({"diff", a, b, "--no-navigation"});
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(text.out,
            "--- " + a + "\n+++ " + b +
                "\n"
                "border     (0, 40) (40, 0) -> (0, 50) (40, 0)\n"
                "moved      obstacle 1 (building): moved 0.5 m by (0.300, 0.400)\n"
                "reshaped   obstacle 2 (building): has another shape, up to 0.707 m off\n"
                "changed    obstacle 3 (building): height_m 3 -> 4 of all segments\n"
                "removed    obstacle 4 (building) with 4 segments at (31.000, 4.000)\n"
                "added      obstacle 6 (building) with 4 segments at (22.000, 32.000)\n"
                "1 added, 1 removed, 1 moved, 1 reshaped, 1 with other attributes, 1 unchanged\n");
  const auto answer = json::parse(run({"diff", a, b, "--format", "json", "--no-navigation"}).out);
  EXPECT_EQ(answer.begin().key(), "after");  // parsed by name; the text begins with the schema
  EXPECT_EQ(answer["schema"], "mapwright.diff/1");
  EXPECT_EQ(answer["same"], false);
  EXPECT_EQ(answer["border"]["after"], json::parse("[0,50,40,0]"));
  EXPECT_EQ(answer["navigation"], nullptr);
  const auto& moved = answer["obstacles"][0];
  EXPECT_EQ(moved["before"], 1);
  EXPECT_NEAR(moved["moved_m"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(answer["obstacles"][2]["attributes"][0]["segments"], json::parse("[1,2,3,4]"));
  EXPECT_EQ(answer["obstacles"][3]["after"], nullptr);
  EXPECT_EQ(answer["obstacles"][4]["before"], nullptr);
}

TEST(Diff, SaysWhatARobotNotices) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", yard(2.0));
  const auto b = folder.file("b.txt", yard(0.4));  // too narrow for a radius of 0.3 m
  const auto result =
      run({"diff", a, b, "--place", "10,15", "--place", "10,2", "--format", "json"});
  EXPECT_EQ(result.status, 1);
  const auto navigation = json::parse(result.out)["navigation"];
  EXPECT_EQ(navigation["routes"]["impossible"], 1);
  EXPECT_EQ(navigation["routes"]["changed"][0]["after_m"], nullptr);
  EXPECT_GT(navigation["routes"]["changed"][0]["before_m"], 15.0);
  EXPECT_EQ(navigation["reachability"]["components"]["before"], 1);
  EXPECT_EQ(navigation["reachability"]["components"]["after"], 2);
  EXPECT_EQ(navigation["reachability"]["changed"][0]["kind"], "split");
  EXPECT_GT(navigation["scans"]["sampled"]["changed"], 0);
  const auto back = json::parse(
      run({"diff", b, a, "--place", "10,15", "--place", "10,2", "--format", "json"}).out);
  EXPECT_EQ(back["navigation"]["routes"]["possible"], 1);
  EXPECT_EQ(back["navigation"]["reachability"]["changed"][0]["kind"], "joined");
}

TEST(Diff, TheSameSeedGivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"diff", folder.file("a.txt", yard(2.0)),
                                          folder.file("b.txt", yard(1.0)), "--format", "json"};
  const auto with = [&](const char* option, const char* value) {
    auto more = words;
    more.insert(more.end(), {option, value});
    return run(more).out;
  };
  EXPECT_EQ(with("--jobs", "1"), with("--jobs", "3"));
  EXPECT_NE(with("--seed", "1"), with("--seed", "2"));
}

TEST(Diff, DrawsAPictureAndAPage) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", yard(2.0));
  const auto b = folder.file("b.txt", yard(1.0));
  const auto page = folder.path("diff.html");
  const auto picture = folder.path("diff.svg");
  EXPECT_EQ(run({"diff", a, b, "--format", "html", "-o", page, "--picture", picture}).status, 1);
  const auto text_of = [](const std::string& path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_NE(text_of(page).find("moved or reshaped: before"), std::string::npos);
  EXPECT_TRUE(text_of(page).starts_with("<!doctype html>"));
  EXPECT_NE(text_of(picture).find("<svg"), std::string::npos);
}

TEST(Diff, RefusesWhatItCannotCompare) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", yard(2.0));
  const auto broken = folder.file("b.txt", yard(2.0) + "obstacle;9;1;4;x");
  EXPECT_EQ(run({"diff", a}).status, 2);
  EXPECT_EQ(run({"diff", a, a, a}).status, 2);
  EXPECT_EQ(run({"diff", "-", "-"}).status, 2);
  EXPECT_EQ(run({"diff", a, a, "--format", "xml"}).status, 2);
  EXPECT_EQ(run({"diff", a, a, "--picture", "x.bmp"}).status, 2);
  EXPECT_EQ(run({"diff", a, a, "--place", "1,1"}).status, 2);
  EXPECT_EQ(run({"diff", a, folder.path("missing.txt")}).status, 3);
  EXPECT_EQ(run({"diff", a, broken}).status, 3);
  EXPECT_EQ(run({"diff", a, broken, "--skip-broken", "--no-navigation"}).err.find("error"),
            std::string::npos);
  EXPECT_EQ(run({"diff", "--git", a, a}).status, 2);
}

TEST(Diff, OfMapsWithoutUsableBorderSkipsNavigationAndSaysSo) {
  const TemporaryFolder folder;
  const auto a = folder.file("a.txt", "border;0;0;0;0;#\n" + box(1, 3, 3, 2));
  const auto b = folder.file("b.txt", "border;0;0;0;0;#\n");
  const auto result = run({"diff", a, b, "--format", "json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("navigation is not compared"), std::string::npos);
  EXPECT_EQ(json::parse(result.out)["counts"]["removed"], 1);
}

// The recipe of docs/diff.md, with git itself.
class DiffInGit : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
    ASSERT_EQ(git("init -q"), 0);
    ASSERT_EQ(git("config user.email a@b.c && git config user.name N"), 0);
    folder_.file(".gitattributes", "*.txt diff=mapwright\n");
    ASSERT_EQ(
        git("config diff.mapwright.command \"'" MAPWRIGHT_PROGRAM "' diff --git --no-navigation\""),
        0);
    commit(yard(2.0), "first");
  }

  int git(const std::string& words) const {
    return std::system(("cd '" + folder_.path("") + "' && git " + words + " >out 2>err").c_str());
  }

  void commit(const std::string& map, const std::string& words) {
    folder_.file("site.txt", map);
    ASSERT_EQ(git("add -A && git commit -qm '" + words + "'"), 0);
  }

  std::string said() const {
    std::ifstream file(folder_.path("out"));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
};

TEST_F(DiffInGit, ShowsObstaclesInsteadOfLines) {
  folder_.file("site.txt", yard(1.0));
  ASSERT_EQ(git("diff"), 0);
  EXPECT_NE(said().find("--- a/site.txt\n+++ b/site.txt\nreshaped   obstacle 1 (fence)"),
            std::string::npos)
      << said();
  EXPECT_EQ(said().find("@@"), std::string::npos);
}

TEST_F(DiffInGit, ShowsHistoryAndNewFiles) {
  commit(yard(1.5), "second");
  ASSERT_EQ(git("log -p --ext-diff --format=%s"), 0);
  EXPECT_NE(said().find("1 reshaped"), std::string::npos) << said();
  EXPECT_NE(said().find("2 added"), std::string::npos) << said();  // the first commit
}

TEST_F(DiffInGit, FollowsARename) {
  ASSERT_EQ(git("mv site.txt yard.txt"), 0);
  folder_.file("yard.txt", yard(1.9));
  ASSERT_EQ(git("add -A && git diff --cached -M HEAD"), 0);
  EXPECT_NE(said().find("--- a/site.txt\n+++ b/yard.txt\n"), std::string::npos) << said();
}

class MergeInGit : public DiffInGit {
 protected:
  void SetUp() override {
    DiffInGit::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    folder_.file(".gitattributes", "*.txt diff=mapwright merge=mapwright\n");
    ASSERT_EQ(git("config merge.mapwright.driver \"git merge-file %A %O %B && "
                  "'" MAPWRIGHT_PROGRAM "' validate --quiet %A\""),
              0);
    commit(maps("3", "3"), "base");
  }

  // Two columns, and whatever else.
  static std::string maps(const char* first, const char* second, const std::string& more = "",
                          const std::string& before = "") {
    return "border;0;20;20;0;#\n" + before + box(1, 3, 3, 2, first) + box(2, 8, 8, 3, second) +
           more;
  }

  int merge(const std::string& ours, const std::string& theirs) {
    EXPECT_EQ(git("checkout -q -b theirs"), 0);
    commit(theirs, "theirs");
    EXPECT_EQ(git("checkout -q -b ours HEAD~1"), 0);
    commit(ours, "ours");
    return git("merge -q --no-edit theirs");
  }

  std::string merged() const {
    std::ifstream file(folder_.path("site.txt"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(MergeInGit, PutsEditsOfDifferentObstaclesTogether) {
  EXPECT_EQ(merge(maps("4", "3"), maps("3", "5")), 0);
  EXPECT_EQ(merged(), maps("4", "5"));
}

TEST_F(MergeInGit, LeavesEditsOfOneObstacleToAPerson) {
  EXPECT_NE(merge(maps("4", "3"), maps("5", "3")), 0);
  EXPECT_NE(merged().find("<<<<<<<"), std::string::npos);
}

TEST_F(MergeInGit, StopsWhereBothSidesTookOneNumber) {
  EXPECT_NE(merge(maps("3", "3", box(7, 14, 3, 2)), maps("3", "3", "", box(7, 3, 14, 2))), 0);
  EXPECT_EQ(merged().find("<<<<<<<"), std::string::npos);
  EXPECT_NE(said().find("[S101]"), std::string::npos) << said();
}

TEST_F(DiffInGit, GoesOnWithAMapThatIsBroken) {
  folder_.file("site.txt", yard(2.0) + "obstacle;9;1;4;x");
  EXPECT_EQ(git("diff"), 0);
}

}  // namespace
}  // namespace mapwright
