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

// Findings of driving and of converting need more than a map file.
bool has_fixture(const FindingType& type) {
  return std::string_view("FGST").find(type.id.front()) != std::string_view::npos;
}

class EveryFinding : public testing::TestWithParam<FindingType> {};

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

TEST_P(EveryFinding, IsTriggeredByItsFixtureAlone) {
  const auto& type = GetParam();
  if (!has_fixture(type)) GTEST_SKIP() << "not a finding about a map file";
  const auto findings = validate(read_map(content(fixture(type, ".txt"))));
  EXPECT_EQ(brief(findings), content(fixture(type, ".expect")));
  for (const auto& finding : findings) {
    EXPECT_EQ(finding.code, type.code);
    EXPECT_EQ(finding.severity, type.severity);
    EXPECT_FALSE(finding.message.empty());
    EXPECT_NE(finding.message.back(), '.');
  }
}

TEST_P(EveryFinding, IsSilentOnANearMiss) {
  const auto& type = GetParam();
  if (!has_fixture(type)) GTEST_SKIP() << "not a finding about a map file";
  EXPECT_EQ(brief(validate(read_map(content(fixture(type, ".ok.txt"))))), "");
}

// The examples of a page are the fixtures, where those can be printed.
TEST_P(EveryFinding, ShowsItsFixtures) {
  const auto& type = GetParam();
  static const std::set<std::string_view> kUnprintable{"F101", "F102", "F103", "F116"};
  if (!has_fixture(type) || kUnprintable.count(type.id) > 0) GTEST_SKIP() << "cannot be printed";
  const auto page = check_page(type.code);
  for (const auto* ending : {".txt", ".ok.txt"}) {
    const auto text = content(fixture(type, ending));
    EXPECT_NE(page.find("```\n" + text + "```\n"), page.npos) << ending;
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryFinding, testing::ValuesIn(finding_catalogue()),
                         [](const auto& test) { return std::string(test.param.id); });

}  // namespace
}  // namespace mapwright::validators
