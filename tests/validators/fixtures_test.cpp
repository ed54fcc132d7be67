// Every finding of the catalogue has a page, a map that triggers it and nothing else, and a map
// that nearly does.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "mapcore/text/reader.hpp"
#include "tests/support/data.hpp"
#include "validators/check_pages.hpp"
#include "validators/validator.hpp"

namespace mapwright::validators {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

std::filesystem::path fixture(const FindingType& type, const std::string& ending) {
  return test::project_file("tests/fixtures/checks/" + std::string(type.id) + ending);
}

template <class Value>
std::string or_dash(const std::optional<Value>& value) {
  return value ? std::to_string(*value) : "-";
}

// "5 1 G104 obstacle 1 segment 3", as in the files *.expect: line, column, code, whom to blame.
std::string brief(const Finding& finding) {
  std::ostringstream out;
  out << finding.place->line << ' ' << finding.place->column << ' ' << finding_type(finding.code).id
      << " obstacle " << or_dash(finding.obstacle) << " segment " << or_dash(finding.segment);
  return out.str();
}

std::string brief(const std::vector<Finding>& findings) {
  std::string text;
  for (const auto& finding : findings) text += brief(finding) + "\n";
  return text;
}

// Findings of driving (N) and of converting (C) need more than a map file.
std::vector<FindingType> findings_of_map_files() {
  std::vector<FindingType> types;
  for (const auto& type : finding_catalogue()) {
    if (std::string_view("FGST").find(type.id.front()) != std::string_view::npos) {
      types.push_back(type);
    }
  }
  return types;
}

// The examples of a page are the fixtures, apart from files that cannot be printed: empty, binary,
// not UTF-8, or without a last line break.
std::vector<FindingType> findings_with_printed_fixtures() {
  static const std::set<std::string_view> kUnprintable{"F101", "F102", "F103", "F116"};
  auto types = findings_of_map_files();
  std::erase_if(types, [](const FindingType& type) { return kUnprintable.count(type.id) > 0; });
  return types;
}

class EveryFinding : public testing::TestWithParam<FindingType> {};
class FindingOfMapFiles : public testing::TestWithParam<FindingType> {};
class FindingWithPrintedFixtures : public testing::TestWithParam<FindingType> {};

TEST_P(EveryFinding, HasAPage) {
  const auto& type = GetParam();
  const auto page = content(test::project_file("docs/checks/" + std::string(type.id) + ".md"));
  EXPECT_EQ(page, check_page(type.code)) << "the program carries another page: build it again";
  EXPECT_TRUE(page.starts_with("# " + std::string(type.id) + " " + std::string(type.name) + "\n"));
  EXPECT_NE(page.find("Severity: " + std::string(to_string(type.severity)) + "."), page.npos);
  EXPECT_NE(page.find(type.summary), page.npos);
  for (const auto* section : {"What is wrong", "Why it hurts a robot", "Examples", "How to fix it",
                              "Parameters", "Cost"}) {
    EXPECT_NE(page.find("\n## " + std::string(section) + "\n"), page.npos) << section;
  }
  const auto index = content(test::project_file("docs/checks/README.md"));
  EXPECT_NE(index.find("(" + std::string(type.id) + ".md)"), index.npos);
}

TEST_P(FindingOfMapFiles, IsTriggeredByItsFixtureAlone) {
  const auto& type = GetParam();
  const auto findings = validate(read_map(content(fixture(type, ".txt"))));
  EXPECT_EQ(brief(findings), content(fixture(type, ".expect")));
  for (const auto& finding : findings) {
    EXPECT_EQ(finding.code, type.code);
    EXPECT_EQ(finding.severity, type.severity);
    EXPECT_FALSE(finding.message.empty());
    EXPECT_NE(finding.message.back(), '.');
  }
}

TEST_P(FindingOfMapFiles, IsSilentOnANearMiss) {
  const auto& type = GetParam();
  EXPECT_EQ(brief(validate(read_map(content(fixture(type, ".ok.txt"))))), "");
}

TEST_P(FindingWithPrintedFixtures, ShowsThemOnItsPage) {
  const auto& type = GetParam();
  const auto page = check_page(type.code);
  for (const auto* ending : {".txt", ".ok.txt"}) {
    const auto text = content(fixture(type, ending));
    EXPECT_NE(page.find("```\n" + text + "```\n"), page.npos) << ending;
  }
}

std::string id_of(const testing::TestParamInfo<FindingType>& test) {
  return std::string(test.param.id);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryFinding, testing::ValuesIn(finding_catalogue()), id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, FindingOfMapFiles, testing::ValuesIn(findings_of_map_files()),
                         id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, FindingWithPrintedFixtures,
                         testing::ValuesIn(findings_with_printed_fixtures()), id_of);

}  // namespace
}  // namespace mapwright::validators
