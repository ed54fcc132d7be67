// Documents that point nowhere, or leave something out, are defects.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cli/verb.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

namespace fs = std::filesystem;
using test::project_file;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// All documents of the project: those of docs/ and samples/, and those at its root.
std::vector<fs::path> documents() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(project_file(""))) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  for (const char* folder : {"docs", "samples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project_file(folder))) {
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
  }
  return found;
}

// Targets of the Markdown links in a text, indented blocks (code) apart.
std::vector<std::string> links_in(const std::string& text) {
  static const std::regex link("\\]\\(([^)\\s]+)\\)");
  std::vector<std::string> targets;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.substr(0, 4) == "    ") continue;
    for (std::sregex_iterator match(line.begin(), line.end(), link), end; match != end; ++match) {
      targets.push_back((*match)[1]);
    }
  }
  return targets;
}

bool is_elsewhere(const std::string& target) {
  return target.find("://") != std::string::npos || target[0] == '#';
}

std::set<std::string> headings_in(const std::string& text, const std::string& prefix) {
  std::set<std::string> headings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.substr(0, prefix.size()) == prefix) headings.insert(line.substr(prefix.size()));
  }
  return headings;
}

// Every page of a folder is linked from its README.md.
void expect_index_names_all(const std::string& folder) {
  const fs::path index = project_file(folder) / "README.md";
  const auto links = links_in(text_of(index));
  const std::set<std::string> linked(links.begin(), links.end());
  for (const auto& entry : fs::directory_iterator(project_file(folder))) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".md" || name == "README.md") continue;
    EXPECT_TRUE(linked.count(name)) << folder << "/README.md does not link " << name;
  }
}

TEST(Documents, AreThere) {
  EXPECT_GT(documents().size(), 40U);
}

TEST(Documents, LinksLeadSomewhere) {
  std::size_t count = 0;
  for (const auto& document : documents()) {
    for (const auto& target : links_in(text_of(document))) {
      if (is_elsewhere(target)) continue;
      const fs::path file = document.parent_path() / target.substr(0, target.find('#'));
      EXPECT_TRUE(fs::exists(file)) << document << " links to " << target;
      ++count;
    }
  }
  EXPECT_GT(count, 50U);
}

TEST(Documents, CommandLinePageHasEveryVerbAndNoOther) {
  auto headings = headings_in(text_of(project_file("docs/cli.md")), "## ");
  headings.erase("For every verb");
  std::set<std::string> verbs;
  for (const auto& verb : cli::verbs()) verbs.insert(std::string(verb.name));
  EXPECT_EQ(headings, verbs);
}

TEST(Documents, IndexesAreComplete) {
  expect_index_names_all("docs/decisions");
  expect_index_names_all("docs/experiments");
  expect_index_names_all("docs/checks");
}

// A comment that sends its reader to a page which is not there.
TEST(Documents, PagesNamedInSourcesExist) {
  static const std::regex page("docs/[a-z_]+\\.md");
  for (const char* folder : {"mapcore", "navcore", "validators", "converter", "cli", "cmake"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project_file(folder))) {
      if (!entry.is_regular_file()) continue;
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator match(text.begin(), text.end(), page), end; match != end; ++match) {
        EXPECT_TRUE(fs::exists(project_file(match->str()))) << entry.path() << ": " << match->str();
      }
    }
  }
}

TEST(DocumentRules, SeeLinksOutsideOfCode) {
  EXPECT_EQ(links_in("a [b](c.md) ![d](e/f.png)\n    [code](no.md)\n[x](y.md#z)"),
            (std::vector<std::string>{"c.md", "e/f.png", "y.md#z"}));
}

}  // namespace
}  // namespace mapwright
