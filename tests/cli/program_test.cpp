// What docs/cli.md promises of every verb, through the executable.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "cli/verb.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/cli/process.hpp"

namespace mapwright {
namespace {

namespace fs = std::filesystem;
using test::run_process;
using test::TemporaryFolder;

Map small_map() {
  Map map{{0.0, 10.0, 10.0, 0.0}, {}};
  Obstacle box{1, ShapeType::kClosedPolygon, Semantic("column"), {}};
  const std::vector<Point> ring = {{4, 4}, {6, 4}, {6, 6}, {4, 6}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    box.segments.push_back({ring[i], ring[(i + 1) % ring.size()], 2.0, InOut::kOutdoor, {}});
  }
  map.obstacles.push_back(box);
  return map;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Names of the files of a folder that are not the test's own redirections.
std::vector<std::string> files_in(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path(""))) {
    const std::string name = entry.path().filename().string();
    if (name.substr(0, 4) != ".std") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Program : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string map_ = folder_.file("map.txt", format_map(small_map()));
};

TEST_F(Program, TellsItsVersion) {
  const auto version = run_process(folder_, {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.substr(0, 10), "mapwright ");
  EXPECT_EQ(version.err, "");
}

TEST_F(Program, ListsEveryVerb) {
  const auto help = run_process(folder_, {"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_EQ(run_process(folder_, {"help"}).out, help.out);
  for (const auto& verb : cli::verbs()) {
    EXPECT_NE(help.out.find("\n  " + std::string(verb.name) + " "), std::string::npos) << verb.name;
    EXPECT_NE(help.out.find(std::string(verb.summary)), std::string::npos) << verb.name;
  }
}

TEST_F(Program, WithoutVerbItHelpsAndFails) {
  const auto nothing = run_process(folder_, {});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE((nothing.out + nothing.err).find("Usage:"), std::string::npos);
}

TEST_F(Program, DoesNotKnowEveryWord) {
  const auto unknown = run_process(folder_, {"convrt"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.out, "");
  EXPECT_NE(unknown.err.find("'convrt'"), std::string::npos);
}

TEST_F(Program, EveryVerbHasHelpToLearnFrom) {
  for (const auto& verb : cli::verbs()) {
    const std::string name(verb.name);
    const auto help = run_process(folder_, {name, "--help"});
    EXPECT_EQ(help.status, 0) << name;
    EXPECT_EQ(help.err, "") << name;
    EXPECT_EQ(help.out.find("Usage: mapwright " + name + " "), 0U) << name;
    for (const char* part : {"Example", "\n  mapwright ", "\nOptions:", "--help"}) {
      EXPECT_NE(help.out.find(part), std::string::npos) << name << ": " << part;
    }
    EXPECT_EQ(run_process(folder_, {"help", name}).out, help.out) << name;
  }
}

// Every option of every verb says something about itself.
TEST_F(Program, EveryOptionIsExplained) {
  for (const auto& verb : cli::verbs()) {
    boost::program_options::options_description options;
    boost::program_options::positional_options_description positionals;
    const auto made = verb.make();
    made->declare(options, positionals);
    for (const auto& option : options.options()) {
      EXPECT_GE(option->description().size(), 8U) << verb.name << " --" << option->long_name();
    }
  }
}

TEST_F(Program, WrongUsageIsStatusTwoAndLeavesStandardOutputEmpty) {
  for (const auto& verb : cli::verbs()) {
    const auto wrong = run_process(folder_, {std::string(verb.name), "--no-such-option"});
    EXPECT_EQ(wrong.status, 2) << verb.name;
    EXPECT_EQ(wrong.out, "") << verb.name;
    EXPECT_NE(wrong.err.find("no-such-option"), std::string::npos) << verb.name;
  }
}

TEST_F(Program, ReadsAMapFromStandardInput) {
  const auto named = run_process(folder_, {"info", map_, "--format", "json"});
  const auto piped =
      run_process(folder_, {"info", "-", "--format", "json"}, {format_map(small_map()), "", 0});
  EXPECT_EQ(piped.status, 0);
  EXPECT_EQ(piped.err, "");
  EXPECT_NE(piped.out.find("\"segments\": 4"), std::string::npos);
  EXPECT_NE(named.out.find("\"segments\": 4"), std::string::npos);
}

TEST_F(Program, AnAnswerThatDoesNotArriveIsStatusFour) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const auto lost = run_process(folder_, {"info", map_}, {"", "/dev/full", 0});
  EXPECT_EQ(lost.status, 4);
  EXPECT_NE(lost.err.find("standard output"), std::string::npos);
}

TEST_F(Program, WritesToDevicesWithoutReplacingThem) {
  ASSERT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(run_process(folder_, {"validate", map_, "-o", "/dev/null"}).status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Program, WritesThroughLinks) {
  const std::string target = folder_.file("target.svg", "old");
  const std::string link = folder_.path("link.svg");
  fs::create_symlink(target, link);
  EXPECT_EQ(run_process(folder_, {"render", map_, "-o", link}).status, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(text_of(target).substr(0, 5), "<?xml");
}

TEST_F(Program, KeepsTheOldFileWhereTheNewOneCannotBeWritten) {
  const std::string picture = folder_.file("picture.png", "old");
  const auto failed = run_process(folder_, {"render", map_, "-o", picture}, {"", "", 2000});
  EXPECT_EQ(failed.status, 4);
  EXPECT_EQ(failed.out, "");
  EXPECT_NE(failed.err.find("picture.png"), std::string::npos);
  EXPECT_EQ(text_of(picture), "old");
  EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"map.txt", "picture.png"}));
}

TEST_F(Program, LeavesNothingWhereTheFolderIsMissing) {
  const auto failed = run_process(folder_, {"render", map_, "-o", folder_.path("none/x.png")});
  EXPECT_EQ(failed.status, 4);
  EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"map.txt"}));
}

}  // namespace
}  // namespace mapwright
