// What convert says of CRSs that are missing or hard to believe.
#include <gtest/gtest.h>

#include <cmath>

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

// Nine houses of the same size in a row.
std::string houses(double x, double y, double unit, double width, double depth) {
  std::string text = "WKT,height\n";
  for (int i = 0; i < 9; ++i) {
    const double left = x + 30.0 * i * unit, bottom = y;
    const auto point = [&](double u, double v) {
      return std::to_string(left + unit * u) + " " + std::to_string(bottom + unit * v);
    };
    text += "\"POLYGON((" + point(0, 0) + "," + point(width, 0) + "," + point(width, depth) + "," +
            point(0, depth) + "," + point(0, 0) + "))\",5\n";
  }
  return text;
}

// Three houses turned by 20 degrees, in degrees.
std::string turned_houses(bool latitude_first) {
  std::string text = "WKT,height\n";
  const double metre = 1.0 / 111320.0, parallel = std::cos(41.39 * std::acos(-1.0) / 180.0);
  for (int i = 0; i < 3; ++i) {
    std::string ring;
    for (const auto& [u, v] : {std::pair{0., 0.}, {12., 0.}, {12., 8.}, {0., 8.}, {0., 0.}}) {
      const double x = 0.94 * u - 0.342 * v + 40 * i, y = 0.342 * u + 0.94 * v;
      char lon[40], lat[40];
      std::snprintf(lon, sizeof lon, "%.9f", 2.11 + x * metre / parallel);
      std::snprintf(lat, sizeof lat, "%.9f", 41.39 + y * metre);
      ring += std::string(ring.empty() ? "" : ",") + (latitude_first ? lat : lon) + " " +
              (latitude_first ? lon : lat);
    }
    text += "\"POLYGON((" + ring + "))\",5\n";
  }
  return text;
}

class StatedCrs : public testing::Test {
 protected:
  std::string messages(const std::string& csv, const std::string& crs) {
    const auto done = run({"convert", folder_.file("site.csv", csv), "-o", folder_.path("map.txt"),
                           "--source-crs", crs});
    EXPECT_LE(done.status, 1) << done.err;
    return done.err;
  }
  void expect(const std::string& csv, const std::string& crs, const std::string& doubt) {
    const auto err = messages(csv, crs);
    EXPECT_NE(err.find(doubt), std::string::npos) << err;
  }
  void expect_belief(const std::string& csv, const std::string& crs) {
    const auto err = messages(csv, crs);
    EXPECT_EQ(err.find("is said"), std::string::npos) << err;
    EXPECT_EQ(err.find("exchanged"), std::string::npos) << err;
  }

  TemporaryFolder folder_;
};

TEST_F(StatedCrs, UtmCalledWebMercatorLiesInTheSea) {
  const auto barcelona = houses(427000, 4582000, 1, 12.03, 8.07);
  expect(barcelona, "EPSG:3857", "lies in the sea, at longitude 3.84");
  expect(barcelona, "EPSG:3857", "look like UTM");
  expect(houses(500000, 140000, 1, 12.03, 8.07), "EPSG:3857", "lies in the sea");  // Singapore
}

// Berlin's coordinates are a place in France: only the drawing itself tells.
TEST_F(StatedCrs, UtmCalledWebMercatorHasRoundLengths) {
  expect(houses(392000, 5820000, 1, 12.0, 8.25), "EPSG:3857", "multiples of 5 cm in its own units");
}

TEST_F(StatedCrs, UtmCalledWebMercatorHasStepsTooShallow) {
  std::string steps = "WKT,height\n";
  for (int i = 0; i < 12; ++i) {
    const auto y = std::to_string(5820000.0 + 0.31 * i);
    steps += "\"LINESTRING(392000 " + y + ",392002.03 " + y + ")\",1\n";
  }
  const auto source = folder_.file("steps.csv", steps);
  const auto done =
      run({"convert", source, "-o", folder_.path("map.txt"), "--source-crs", "EPSG:3857"});
  EXPECT_NE(done.err.find("has steps that would be 0.21 m deep"), std::string::npos) << done.err;
}

std::string doors(double x, double y, double width) {
  std::string text = "WKT,height\n";
  for (int i = 0; i < 5; ++i) {
    const auto at = std::to_string(y + 3.017 * i);
    text += "\"LINESTRING(" + std::to_string(x) + " " + at + "," + std::to_string(x + width) + " " +
            at + ")\",2\n";
  }
  return text;
}

TEST_F(StatedCrs, UtmCalledWebMercatorHasDoorsTooNarrow) {
  const auto said = [&](const std::string& csv) {
    return run({"convert", folder_.file("doors.csv", csv), "-o", folder_.path("map.txt"),
                "--source-crs", "EPSG:3857"})
        .err;
  };
  const auto berlin = said(doors(392000, 5820000, 0.9));
  EXPECT_NE(berlin.find("has doors that would be 0.62 m wide on the ground"), std::string::npos)
      << berlin;
  const double paris = 1.0 / std::cos(48.85 * std::acos(-1.0) / 180.0);
  const auto believed = said(doors(261000, 6250000, 0.9 * paris));
  EXPECT_EQ(believed.find("is said"), std::string::npos) << believed;
}

// Paris and Barcelona have such coordinates in Web Mercator too, and round lengths there are
// nobody's.
TEST_F(StatedCrs, RealWebMercatorIsBelieved) {
  const double paris = 1.0 / std::cos(48.85 * std::acos(-1.0) / 180.0);
  expect_belief(houses(261000, 6250000, paris, 12.0, 8.25), "EPSG:3857");
  const double barcelona = 1.0 / std::cos(41.39 * std::acos(-1.0) / 180.0);
  expect_belief(houses(235200, 5069000, barcelona, 12.0, 8.25), "EPSG:3857");
  expect_belief(houses(-8240000, 4970000, 1, 12.0, 8.25), "EPSG:3857");  // New York
}

TEST_F(StatedCrs, ExchangedAxesOfAProjectedCrsAreDoubtedByTheirPlace) {
  expect(houses(4582000, 427000, 1, 12, 8), "EPSG:25831", "the order of the axes? (--override-crs");
}

// EPSG:2229 counts US feet, EPSG:26945 metres, of one plane.
TEST_F(StatedCrs, FeetOfAStatePlaneCalledMetresAreDoubtedByTheirPlace) {
  const auto los_angeles = houses(6480000, 1840000, 3.28, 12, 8);
  expect(los_angeles, "EPSG:26945", "which is meant for longitudes");
  expect_belief(los_angeles, "EPSG:2229");
}

// Too few corners to refuse, enough to ask.
TEST_F(StatedCrs, ExchangedDegreesOfASmallDrawingAreAskedAbout) {
  expect(turned_houses(true), "EPSG:4326", "longitude and latitude may be exchanged");
  expect_belief(turned_houses(false), "EPSG:4326");
}

}  // namespace
}  // namespace mapwright::test
