// The exact planner on maps that are not as they should be.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mapcore/text/writer.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;

class PlanExactly : public testing::Test {
 protected:
  void use(const Map& map) { map_ = folder_.file("map.txt", format_map(map)); }

  Json plan(const std::string& start, const std::string& goal, const std::string& radius,
            int status = 0) {
    last_ = run({"plan", map_, "--planner", "exact", "--start", start, "--goal", goal, "--radius",
                 radius, "--format", "json"});
    EXPECT_EQ(last_.status, status) << last_.err;
    return last_.status > 1 ? Json() : Json::parse(last_.out)["queries"][0];
  }

  TemporaryFolder folder_;
  std::string map_;
  ProgramRun last_;
};

Obstacle open_wall(std::int64_t id, std::vector<Point> points) {
  Obstacle wall = ring(id, points);
  wall.segments.pop_back();
  return wall;
}

// A box whose outline does not close: 0.5 m are missing in its right side.
TEST_F(PlanExactly, GoesThroughALeakThatIsJustWideEnough) {
  use(map10({open_wall(1, {{7, 5}, {7, 7}, {3, 7}, {3, 3}, {7, 3}, {7, 4.5}})}));
  const Json in = plan("5,6", "1,5", "0.25");
  EXPECT_EQ(in["reachable"], true);
  EXPECT_NEAR(in["bottleneck_m"], 0.5, 1e-12);
  EXPECT_GE(in["min_clearance_m"], 0.25 - 1e-9);
  const Json out = plan("5,6", "1,5", "0.2501", 1);
  EXPECT_EQ(out["reachable"], false);
  EXPECT_FALSE(out["barrier"].empty());
  EXPECT_NE(last_.err.find("warning"), 0U);
}

TEST_F(PlanExactly, SaysThatCrossingWallsWereMoved) {
  use(map10({open_wall(1, {{3, 3}, {7, 7.001}}), open_wall(2, {{3, 7}, {7.003, 3}})}));
  const Json answer = plan("5,1", "5,9", "0.2");
  EXPECT_EQ(answer["reachable"], true);
  const std::string caution = answer["caution"];
  EXPECT_NE(caution.find("0.71 mm"), std::string::npos) << caution;
  EXPECT_NE(last_.err.find("warning: the exact planner moved walls"), std::string::npos);
  const ProgramRun check =
      run({"check", map_, "--trials", "0", "--plans", "1", "--format", "json"});
  const Json reach = Json::parse(check.out)["maps"][0]["reachability"];
  EXPECT_NEAR(reach["walls_moved_m"], 0.0007072, 1e-9);
  EXPECT_NEAR(reach["walls_moved_at"][0], 5.0, 0.01);
}

TEST_F(PlanExactly, SaysWhichCornerIsOffTheGrid) {
  use(map10({}));
  map_ = folder_.file("fine.txt",
                      "border;0;10;10;0;#obstacle;1;1;3;x;#4;4;6;4.0004;3;1;x;#6;4.0004;5;6;3;1;x;#"
                      "5;6;4;4;3;1;x;#");
  const std::string caution = plan("1,1", "9,9", "0.2")["caution"];
  EXPECT_NE(caution.find("0.40 mm"), std::string::npos) << caution;
  EXPECT_NE(caution.find("(6.000, 4.000)"), std::string::npos) << caution;
}

TEST_F(PlanExactly, HasNothingToSayOfMapsOnTheGrid) {
  use(map10({box(1, 4, 4, 6, 6)}));
  EXPECT_FALSE(plan("1,1", "9,9", "0.2").contains("caution"));
  EXPECT_EQ(last_.err, "");
}

TEST_F(PlanExactly, GoesStraightThroughAnEmptyMap) {
  use(map10({}));
  EXPECT_NEAR(plan("1,1", "9,7", "0")["length_m"], 10.0, 1e-12);
  EXPECT_NEAR(plan("1.5,2", "7.5,8", "1")["length_m"], std::hypot(6.0, 6.0), 1e-12);
  EXPECT_EQ(plan("1,1", "1,1", "0.3")["length_m"], 0.0);
  const Json beyond = plan("0.5,1", "9,7", "1", 1);
  EXPECT_EQ(beyond["solved"], false);
  const ProgramRun check = run({"check", map_, "--trials", "0", "--plans", "1"});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
}

TEST_F(PlanExactly, NamesObstaclesBeyondTheGrid) {
  use(map10({box(7, 2e6, 4, 2e6 + 1, 6)}));
  plan("1,1", "9,7", "0", 3);
  EXPECT_NE(last_.err.find("obstacle 7 lies more than 500 km"), std::string::npos) << last_.err;
}

}  // namespace
}  // namespace mapwright
