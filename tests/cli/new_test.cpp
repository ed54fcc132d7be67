// The verb new.
#include <gtest/gtest.h>

#include "tests/cli/program_run.hpp"

namespace mapwright::test {
namespace {

namespace fs = std::filesystem;

TEST(New, MakesASiteThatConvertsEmptyToARefusalAndNoMap) {
  const TemporaryFolder folder;
  const std::string site = folder.path("site.gpkg"), map = folder.path("site.txt");
  const auto made = run({"new", site, "--origin", "41.389,2.113", "--heading", "-20"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("7 layers"), std::string::npos) << made.err;
  EXPECT_EQ(made.out, "");
  const auto converted = run({"convert", site, "-o", map});
  EXPECT_EQ(converted.status, 1) << converted.err;
  EXPECT_NE(converted.err.find("nothing in the sources becomes an obstacle"), std::string::npos);
  EXPECT_FALSE(fs::exists(map));
}

TEST(New, LeavesADrawingThatIsThereAlone) {
  const TemporaryFolder folder;
  const std::string site = folder.path("site.gpkg");
  std::ofstream(site) << "a drawing";
  const auto refused = run({"new", site, "--origin", "41.389,2.113"});
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("--overwrite"), std::string::npos) << refused.err;
  EXPECT_EQ(fs::file_size(site), 9u);
  EXPECT_EQ(run({"new", site, "--origin", "41.389,2.113", "--overwrite"}).status, 0);
  EXPECT_GT(fs::file_size(site), 9u);
}

TEST(New, SaysWhatIsWrongWithItsOptions) {
  const TemporaryFolder folder;
  const std::string site = folder.path("site.gpkg");
  const auto message = [&](std::vector<std::string> arguments) {
    const auto refused = run(arguments);
    EXPECT_EQ(refused.status, 2) << refused.err;
    return refused.err;
  };
  EXPECT_NE(message({"new", site}).find("--origin LAT,LON is missing"), std::string::npos);
  EXPECT_NE(message({"new", folder.path("site.shp"), "--origin", "41,2"}).find(".gpkg"),
            std::string::npos);
  EXPECT_NE(message({"new", site, "--origin", "141,2"}).find("--origin"), std::string::npos);
  EXPECT_NE(message({"new", site, "--origin", "41,2", "--crs", "EPSG:0"}).find("--crs"),
            std::string::npos);
  EXPECT_NE(message({"new", site, "--origin", "41,2", "--size", "0,5"}).find("--size"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(site));
}

TEST(New, NamesTheFolderThatIsMissing) {
  const TemporaryFolder folder;
  const auto refused = run({"new", folder.path("nowhere/site.gpkg"), "--origin", "41,2"});
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_NE(refused.err.find("nowhere"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace mapwright::test
