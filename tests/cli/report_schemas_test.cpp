// Reports against the schemas their formats are published with. The schemas are not part of this
// project: the variable MAPWRIGHT_SCHEMAS names a folder that holds them (docs/reports.md says
// where they come from); without it these tests are skipped.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/program_run.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

namespace fs = std::filesystem;

// All fixtures, and a map that is not there.
std::vector<std::string> maps() {
  std::vector<std::string> paths{"no such map.txt"};
  for (const auto& entry : fs::directory_iterator(test::project_file("tests/fixtures/checks"))) {
    if (entry.path().extension() == ".txt") paths.push_back(entry.path().string());
  }
  return paths;
}

class Schema : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("MAPWRIGHT_SCHEMAS");
    if (folder == nullptr) GTEST_SKIP() << "MAPWRIGHT_SCHEMAS does not name a folder of schemas";
    schemas_ = folder;
  }

  std::string report(const std::string& format) const {
    const std::string path = folder_.path("report." + format);
    std::vector<std::string> arguments = maps();
    arguments.insert(arguments.begin(), {"validate", "--quiet", "--format", format, "-o", path});
    EXPECT_EQ(test::run(arguments).status, 3);
    return path;
  }

  // A shell command that says with its status whether the report fits the schema.
  void expect_fits(const std::string& tool, const std::string& schema, const std::string& command) {
    const fs::path path = schemas_ / schema;
    if (std::system((tool + " >/dev/null 2>&1").c_str()) != 0) GTEST_SKIP() << tool << " fails";
    ASSERT_TRUE(fs::exists(path)) << path;
    EXPECT_EQ(std::system((command + " >&2").c_str()), 0) << command;
  }

  fs::path schemas_;
  test::TemporaryFolder folder_;
};

TEST_F(Schema, OfSarifFits) {
  const std::string schema = (schemas_ / "sarif-schema-2.1.0.json").string();
  expect_fits("python3 -c 'import jsonschema'", "sarif-schema-2.1.0.json",
              "python3 -W ignore -m jsonschema -i '" + report("sarif") + "' '" + schema + "'");
}

TEST_F(Schema, OfJunitInJenkinsFits) {
  const std::string schema = (schemas_ / "junit-10.xsd").string();
  expect_fits("xmllint --version", "junit-10.xsd",
              "xmllint --noout --schema '" + schema + "' '" + report("junit") + "'");
}

TEST_F(Schema, OfJunitInAntFits) {
  const std::string schema = (schemas_ / "JUnit.xsd").string();
  expect_fits("xmllint --version", "JUnit.xsd",
              "xmllint --noout --schema '" + schema + "' '" + report("junit") + "'");
}

}  // namespace
}  // namespace mapwright
