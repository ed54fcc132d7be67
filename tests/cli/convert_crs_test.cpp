// What convert says of CRSs that are missing or hard to believe.
#include <gtest/gtest.h>

#include "tests/cli/program_run.hpp"

namespace mapwright::test {
namespace {

// A house of 12 by 8 units at (x, y), as CSV with WKT, which states no CRS.
std::string house(double x, double y, double unit) {
  const auto point = [&](double u, double v) {
    return std::to_string(x + unit * u) + " " + std::to_string(y + unit * v);
  };
  return "WKT,height\n\"POLYGON((" + point(0, 0) + "," + point(12, 0) + "," + point(12, 8) + "," +
         point(0, 8) + "," + point(0, 0) + "))\",5\n";
}

TEST(ConvertCrs, RefusesAnUnstatedOneWithRankedGuesses) {
  const TemporaryFolder folder;
  const auto source = folder.file("houses.csv", house(430000, 4582000, 1));
  const auto refused = run({"convert", source, "-o", folder.path("map.txt")});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.err.find("states no coordinate reference system"), std::string::npos);
  EXPECT_NE(refused.err.find("1. UTM"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("latitude 41.3"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("map.txt")));
}

TEST(ConvertCrs, TakesLocalCoordinatesInAnotherUnit) {
  const TemporaryFolder folder;
  const auto source = folder.file("houses.csv", house(1000, 2000, 1000));
  const auto done = run({"convert", source, "-o", "-", "--local", "--local-unit", "0.001"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("13;10;"), std::string::npos) << done.out;
  EXPECT_EQ(run({"convert", source, "-o", "-", "--local-unit", "0.001"}).status, 2);
  EXPECT_EQ(run({"convert", source, "-o", "-", "--local", "--local-unit", "0"}).status, 2);
}

TEST(ConvertCrs, DoubtsDegreesThatAreCalledMetres) {
  const TemporaryFolder folder;
  const auto source = folder.file("houses.csv", house(2.113, 41.389, 1e-5));
  const auto doubted =
      run({"convert", source, "-o", folder.path("map.txt"), "--source-crs", "EPSG:25831"});
  EXPECT_NE(doubted.err.find("look like degrees"), std::string::npos) << doubted.err;
  const auto local = run({"convert", source, "-o", folder.path("local.txt"), "--local"});
  EXPECT_NE(local.status, 0);
}

TEST(ConvertCrs, DoubtsAPlaceOutsideOfTheCrs) {
  const TemporaryFolder folder;
  const auto source = folder.file("houses.csv", house(430000, 4582000, 1));
  const auto doubted =
      run({"convert", source, "-o", folder.path("map.txt"), "--source-crs", "EPSG:28992"});
  EXPECT_EQ(doubted.status, 0) << doubted.err;
  EXPECT_NE(doubted.err.find("which is meant for longitudes"), std::string::npos) << doubted.err;
  const auto believed =
      run({"convert", source, "-o", folder.path("map.txt"), "--override-crs", "EPSG:25831"});
  EXPECT_EQ(believed.err.find("meant for"), std::string::npos) << believed.err;
}

}  // namespace
}  // namespace mapwright::test
