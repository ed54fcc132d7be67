// The examples of docs/reports.md are what the program writes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// As a block of code in Markdown.
std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    block += line.empty() ? "\n" : "    " + line + "\n";
  }
  return block;
}

class ReportPage : public testing::TestWithParam<std::string> {};

TEST_P(ReportPage, ShowsWhatTheProgramWrites) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(test::project_file("tests/fixtures/reports"));
  const auto result = test::run({"validate", "site.txt", "--format", GetParam()});
  std::filesystem::current_path(before);
  EXPECT_EQ(result.status, 1);
  const std::string page = content(test::project_file("docs/reports.md"));
  EXPECT_NE(page.find("\n\n" + indented(result.out) + "\n"), page.npos) << indented(result.out);
}

TEST(ReportPageOf, ShowsTheMap) {
  const std::string map = content(test::project_file("tests/fixtures/reports/site.txt"));
  EXPECT_NE(content(test::project_file("docs/reports.md")).find(indented(map)), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Formats, ReportPage,
                         testing::Values("text", "junit", "github", "geojson"));

}  // namespace
}  // namespace mapwright
