// convert --watch, as a process of its own.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/cli/process.hpp"

namespace mapwright::test {
namespace {

std::string drawing(double height) {
  return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":)" +
         std::to_string(height) +
         R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]}}]})";
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Generous, for machines with much else to do; a watch that works needs less than a second.
bool comes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 600; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

// Ends the program when the test ends, however it ends.
class Watching {
 public:
  // Its standard output goes to `out`, unless empty.
  explicit Watching(std::vector<std::string> arguments, const std::string& out = "") {
    arguments.insert(arguments.begin(), MAPWRIGHT_PROGRAM);
    child_ = ::fork();
    if (child_ != 0) return;
    if (!out.empty() && std::freopen(out.c_str(), "w", stdout) == nullptr) ::_exit(126);
    std::vector<char*> words;
    for (auto& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  ~Watching() { end(); }

  int end() {
    if (child_ == 0) return 0;
    int status = 0;
    ::kill(child_, SIGTERM);
    ::waitpid(child_, &status, 0);
    child_ = 0;
    return status;
  }

 private:
  pid_t child_ = 0;
};

TEST(Watch, ConvertsAgainWhenTheSourceIsSavedAndOutlivesAMistake) {
  const TemporaryFolder folder;
  const std::string source = folder.file("buildings.geojson", drawing(3.25));
  const std::string map = folder.path("buildings.txt");
  Watching watching({"convert", source, "-o", map, "--local", "--watch", "--quiet"});
  ASSERT_TRUE(comes_true([&] { return text_of(map).find("3.25;") != std::string::npos; }));
  folder.file("buildings.geojson", drawing(7.5));
  ASSERT_TRUE(comes_true([&] { return text_of(map).find("7.5;") != std::string::npos; }));
  folder.file("buildings.geojson", "{ this is no drawing");
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  EXPECT_NE(text_of(map).find("7.5;"), std::string::npos) << "the last good map stays";
  folder.file("buildings.geojson", drawing(9.125));
  EXPECT_TRUE(comes_true([&] { return text_of(map).find("9.125;") != std::string::npos; }));
  watching.end();
  for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
    const auto name = entry.path().filename().string();
    EXPECT_TRUE(name == "buildings.geojson" || name == "buildings.txt")
        << name << " is left behind";
  }
}

// One whole document after the other, each as soon as it is known: what `jq` and the like read.
TEST(Watch, WritesALedgerOfEachConversionToStandardOutput) {
  const TemporaryFolder folder;
  const std::string source = folder.file("buildings.geojson", drawing(3.25));
  const std::string out = folder.path("ledgers.json");
  const std::string map = folder.path("buildings.txt");
  Watching watching({"convert", source, "-o", map, "--report", "-", "--local", "--watch"}, out);
  // Those that are whole.
  const auto ledgers = [&] {
    std::vector<nlohmann::json> documents;
    std::istringstream text(text_of(out));
    try {
      for (nlohmann::json document; text >> std::ws && !text.eof() && text >> document;) {
        documents.push_back(document);
      }
    } catch (const nlohmann::json::parse_error&) {
    }
    return documents;
  };
  ASSERT_TRUE(comes_true([&] { return ledgers().size() == 1; }));
  folder.file("buildings.geojson", "{ this is no drawing");
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  EXPECT_EQ(ledgers().size(), 1U) << "what cannot be read has no ledger";
  folder.file("buildings.geojson", drawing(7.5));
  ASSERT_TRUE(comes_true([&] { return ledgers().size() == 2; }));
  for (const auto& ledger : ledgers()) EXPECT_EQ(ledger["totals"]["written"], 1);
}

TEST(Watch, NeedsAFileToWrite) {
  const auto refused = run({"convert", "a.geojson", "-o", "-", "--watch"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--watch"), std::string::npos);
}

}  // namespace
}  // namespace mapwright::test
