// convert --snap, --dissolve, --simplify, and what the ledger measures.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/program_run.hpp"

namespace mapwright::test {
namespace {

using Json = nlohmann::json;

std::string csv(const std::vector<std::string>& geometries) {
  std::string text = "WKT,height\n";
  for (const auto& wkt : geometries) text += "\"" + wkt + "\",5\n";
  return text;
}

class Tidy : public testing::Test {
 protected:
  // Converts and returns the ledger; the map is in map_.
  Json converted(const std::string& layer, const std::vector<std::string>& geometries,
                 std::vector<std::string> options) {
    const auto source = folder_.file(layer + ".csv", csv(geometries));
    std::vector<std::string> arguments{"convert",
                                       source,
                                       "-o",
                                       folder_.path("map.txt"),
                                       "--local",
                                       "--report",
                                       folder_.path("ledger.json")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto done = run(arguments);
    EXPECT_EQ(done.status, 0) << done.err;
    std::ifstream map(folder_.path("map.txt")), ledger(folder_.path("ledger.json"));
    map_ = {std::istreambuf_iterator<char>(map), {}};
    return Json::parse(ledger);
  }

  std::size_t segments() const {
    const auto answer = run({"info", folder_.path("map.txt"), "--format", "json"});
    return Json::parse(answer.out)["segments"];
  }

  TemporaryFolder folder_;
  std::string map_;
};

TEST_F(Tidy, SnapsEndsThatNearlyMeet) {
  const auto ledger = converted("walls", {"LINESTRING(0 0,5 0)", "LINESTRING(5.004 0.003,5 4)"},
                                {"--snap", "0.01"});
  const auto& reasons = ledger["features"][1]["reasons"];
  ASSERT_EQ(ledger["features"][1]["outcome"], "changed");
  EXPECT_EQ(reasons.back()["code"], "C250");
  EXPECT_NEAR(reasons.back()["hausdorff_m"].get<double>(), 0.005, 1e-6);
  EXPECT_EQ(map_.find("5.004"), std::string::npos) << map_;
  EXPECT_EQ(ledger["features"][0]["outcome"], "written");
}

TEST_F(Tidy, LeavesWhatIsFartherApart) {
  const auto ledger =
      converted("walls", {"LINESTRING(0 0,5 0)", "LINESTRING(5.02 0,5 4)"}, {"--snap", "0.01"});
  EXPECT_EQ(ledger["totals"]["changed"], 0);
  EXPECT_NE(map_.find("5.02;0"), std::string::npos);
}

TEST_F(Tidy, DissolvesARowOfHousesButNotAHigherOne) {
  const auto source = folder_.file("buildings.csv",
                                   "WKT,height\n\"POLYGON((0 0,5 0,5 8,0 8,0 0))\",6\n"
                                   "\"POLYGON((5 0,10 0,10 8,5 8,5 0))\",6\n"
                                   "\"POLYGON((10 0,15 0,15 8,10 8,10 0))\",9\n");
  const auto done = run({"convert", source, "-o", folder_.path("map.txt"), "--local", "--dissolve",
                         "--report", folder_.path("ledger.json")});
  ASSERT_EQ(done.status, 0) << done.err;
  std::ifstream file(folder_.path("ledger.json"));
  const Json ledger = Json::parse(file);
  EXPECT_EQ(ledger["features"][0]["obstacles"], ledger["features"][1]["obstacles"]);
  EXPECT_EQ(ledger["features"][0]["reasons"].back()["code"], "C252");
  EXPECT_NEAR(ledger["features"][0]["reasons"].back()["area_change_m2"].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(ledger["features"][2]["outcome"], "written");
  EXPECT_EQ(segments(), 8u);
}

std::string circle(double radius, int corners) {
  std::string points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2.0 * M_PI * (i % corners) / corners;
    points += (i == 0 ? "" : ",") + std::to_string(20 + radius * std::cos(angle)) + " " +
              std::to_string(20 + radius * std::sin(angle));
  }
  return "POLYGON((" + points + "))";
}

TEST_F(Tidy, SimplifiesWithinTheBoundItStates) {
  const auto ledger = converted("buildings", {circle(3.0, 400)}, {"--simplify", "0.05"});
  const auto& reason = ledger["features"][0]["reasons"].back();
  EXPECT_EQ(reason["code"], "C251");
  EXPECT_LE(reason["hausdorff_m"].get<double>(), 0.0502);
  EXPECT_GT(reason["hausdorff_m"].get<double>(), 0.01);
  EXPECT_LT(std::abs(reason["area_change_m2"].get<double>()), 0.05 * 2 * M_PI * 3.0);
  EXPECT_LT(segments(), 40u);
  EXPECT_GE(segments(), 12u);
}

TEST_F(Tidy, KeepsSharedVerticesWhenSimplifying) {
  // Two buildings that share a slightly bent wall: the bend must stay on both sides.
  const auto ledger = converted(
      "buildings",
      {"POLYGON((0 0,5 0,5.02 4,5 8,0 8,0 0))", "POLYGON((5 0,10 0,10 8,5 8,5.02 4,5 0))"},
      {"--simplify", "0.1"});
  EXPECT_EQ(ledger["totals"]["changed"], 0);
}

TEST_F(Tidy, MeasuresWhatTheRepairOfABowTieMoves) {
  const auto ledger = converted("buildings", {"POLYGON((0 0,4 4,4 0,0 4,0 0))"}, {});
  const auto& reason = ledger["features"][0]["reasons"].back();
  EXPECT_EQ(reason["code"], "C201");
  EXPECT_NEAR(reason["hausdorff_m"].get<double>(), 0.0, 1e-3);  // the same lines, cut
  EXPECT_NEAR(reason["area_change_m2"].get<double>(), 8.0, 1e-6);
}

TEST_F(Tidy, RefusesDistancesThatMakeNoSense) {
  EXPECT_EQ(run({"convert", "a.csv", "-o", "b.txt", "--snap", "-1"}).status, 2);
  EXPECT_EQ(run({"convert", "a.csv", "-o", "b.txt", "--simplify", "x"}).status, 2);
}

}  // namespace
}  // namespace mapwright::test
