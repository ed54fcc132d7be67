// Every GIS file of the real data through the program: no crash, no hang, nothing lost in silence.
#include <gtest/gtest.h>

#include "tests/sources/survey.hpp"
#include "tests/support/data.hpp"

namespace mapwright {
namespace {

using test::SurveyRow;

constexpr double kMostWork_s = 5.0;  // of processor time
// A loaded machine is no hang.
constexpr double kLimit_s = 60.0;

void expect_honest(const SurveyRow& row) {
  SCOPED_TRACE(row.file + " " + row.options + ": " + row.message);
  EXPECT_FALSE(row.hung);
  EXPECT_LT(row.seconds, kMostWork_s);
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

// What files of the field say of themselves is true.
void expect_belief(const SurveyRow& row) {
  EXPECT_FALSE(row.status == 0 && row.doubts_crs) << row.file << " " << row.options;
}

void survey(const std::string& folder, bool is_real) {
  const auto root = test::real_data_folder();
  const auto files = test::vector_files(root, folder);
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) {
    for (const auto& row : test::survey_file(MAPWRIGHT_PROGRAM, root, file, kLimit_s)) {
      expect_honest(row);
      if (is_real) expect_belief(row);
    }
  }
}

TEST(SourceSurvey, RealFiles) {
  MAPWRIGHT_REQUIRE_REAL_DATA("1_gis");
  survey("1_gis", true);
}

TEST(SourceSurvey, HostileFiles) {
  MAPWRIGHT_REQUIRE_REAL_DATA("2_hostile");
  survey("2_hostile", false);
}

}  // namespace
}  // namespace mapwright
