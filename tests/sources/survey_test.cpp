// Every GIS file of the real data through the program: no crash, no hang, nothing lost in silence.
#include <gtest/gtest.h>

#include "tests/sources/survey.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::SurveyRow;

// A loaded machine is no hang: five seconds of work, and what waiting for the processor adds.
constexpr double kLimit_s = 60.0;

void expect_honest(const SurveyRow& row) {
  SCOPED_TRACE(row.file + " " + row.options + ": " + row.message);
  EXPECT_FALSE(row.hung);
  EXPECT_TRUE(row.status == 0 || row.status == 1 || row.status == 3) << "status " << row.status;
  if (row.has_ledger) {
    EXPECT_EQ(row.features, row.written + row.changed + row.dropped);
  }
  if (row.status == 0) {
    EXPECT_TRUE(row.has_ledger);
    EXPECT_FALSE(row.loses);
    EXPECT_GT(row.written + row.changed, 0U);
  } else {
    EXPECT_NE(row.message.find("error: "), std::string::npos) << "no word on what is wrong";
  }
  if (row.status == 3 && !row.has_ledger) {
    const auto name = std::filesystem::path(row.file).stem().string();
    EXPECT_NE(row.message.find(name), std::string::npos) << "the message names the file";
  }
}

void survey(const std::string& folder) {
  const auto root = test::real_data_folder();
  const auto files = test::vector_files(root, folder);
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) {
    for (const auto& row : test::survey_file(MAPWRIGHT_PROGRAM, root, file, kLimit_s)) {
      expect_honest(row);
    }
  }
}

TEST(SourceSurvey, RealFiles) {
  MAPWRIGHT_REQUIRE_REAL_DATA("1_gis");
  survey("1_gis");
}

TEST(SourceSurvey, HostileFiles) {
  MAPWRIGHT_REQUIRE_REAL_DATA("2_hostile");
  survey("2_hostile");
}

}  // namespace
}  // namespace mapwright
