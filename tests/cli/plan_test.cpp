#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mapcore/text/writer.hpp"
#include "navcore/free_space.hpp"
#include "tests/cli/program_run.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/navcore/slow_collision.hpp"

namespace mapwright {
namespace {

using namespace mapwright::test;
using Json = nlohmann::ordered_json;

// Two rooms of 10 m × 10 m with a door of 0.8 m, a courtyard nobody can enter, a ramp, stairs.
Map site() {
  return map({0, 10, 20, 0}, {box(1, 9.9, 0, 10.1, 4.6), box(2, 9.9, 5.4, 10.1, 10),
                              box(3, 2, 6, 6, 9), hollow(4, 3, 7, 5, 8, "court,inner_of=3"),
                              ramp(12, 14, 1, 16, 3), stairs(5, 12, 14, 7, 3)});
}

class PlanVerb : public testing::Test {
 protected:
  ProgramRun plan(std::vector<std::string> options) const {
    options.insert(options.begin(), {"plan", map_});
    return run(options);
  }
  Json plan_json(std::vector<std::string> options, int status = 0) const {
    options.insert(options.end(), {"--format", "json"});
    const ProgramRun run = plan(options);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.err, "");
    return Json::parse(run.out);
  }
  static std::vector<Point> path_of(const Json& query) {
    std::vector<Point> path;
    for (const auto& p : query.at("path")) path.push_back({p.at(0), p.at(1)});
    return path;
  }

  TemporaryFolder folder_;
  Map site_ = site();
  std::string map_ = folder_.file("site.txt", format_map(site_));
};

TEST_F(PlanVerb, AnswersByTheContract) {
  for (const std::string planner : {"rrt", "balanced-rrt"}) {
    const Json answer =
        plan_json({"--start", "1,1", "--goal", "19,9", "--radius", "0.3", "--planner", planner});
    EXPECT_EQ(answer.begin().key(), "schema");
    EXPECT_EQ(answer["schema"], "mapwright.plan/1");
    EXPECT_EQ(answer["planner"], planner);
    ASSERT_EQ(answer["queries"].size(), 1U);
    const Json& query = answer["queries"][0];
    EXPECT_EQ(query["start"], Json::array({1.0, 1.0}));
    EXPECT_EQ(query["goal"], Json::array({19.0, 9.0}));
    EXPECT_EQ(query["solved"], true);
    EXPECT_GT(query["iterations"], 0);
    const auto path = path_of(query);
    const navcore::FreeSpace space(site_);
    const double clearance = slow_clearance_m(space.segments(), path);
    EXPECT_GE(clearance, 0.3);
    EXPECT_NEAR(query["min_clearance_m"], clearance, 1e-12);
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    EXPECT_NEAR(query["length_m"], length, 1e-9);
    EXPECT_FALSE(query.contains("tree"));
    EXPECT_FALSE(query.contains("raw_path"));
  }
}

TEST_F(PlanVerb, AnswersExactlyWhereThereIsAWay) {
  const Json answer = plan_json({"--start", "5,2", "--goal", "19,9", "--planner", "exact"});
  const Json& query = answer["queries"][0];
  EXPECT_EQ(query["solved"], true);
  EXPECT_EQ(query["reachable"], true);
  EXPECT_NEAR(query["bottleneck_m"], 0.8, 1e-9);
  EXPECT_EQ(query["bottleneck_at"].size(), 2U);
  EXPECT_EQ(path_of(query)[1], (Point{9.9, 4.6}));
  EXPECT_FALSE(query.contains("barrier"));
}

TEST_F(PlanVerb, DecidesExactlyWhetherTheRobotFitsADoor) {
  const auto query = [&](const char* radius, int status) {
    return plan_json({"--start", "5,2", "--goal", "19,9", "--planner", "exact", "--radius", radius},
                     status)["queries"][0];
  };
  const Json fits = query("0.4", 0);
  EXPECT_EQ(fits["reachable"], true);
  EXPECT_NEAR(fits["bottleneck_m"], 0.8, 1e-12);
  EXPECT_NEAR(fits["min_clearance_m"], 0.4, 1e-9);
  const Json stuck = query("0.400001", 1);
  EXPECT_EQ(stuck["reachable"], false);
  EXPECT_GE(stuck["barrier"].size(), 4U);
}

TEST_F(PlanVerb, AnswersExactlyWhereThereIsNone) {
  const Json answer =
      plan_json({"--start", "5,2", "--goal", "19,9", "--planner", "exact", "--radius", "0.41"}, 1);
  const Json& query = answer["queries"][0];
  EXPECT_EQ(query["solved"], false);
  EXPECT_EQ(query["reachable"], false);
  EXPECT_NEAR(query["bottleneck_m"], 0.8, 1e-9);
  EXPECT_GE(query["barrier"].size(), 4U);
}

TEST_F(PlanVerb, TextNamesLengthClearanceAndPoints) {
  const ProgramRun run = plan({"--start", "1,1", "--goal", "9,1"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out,
            "(1, 1) to (9, 1): path of 8.000 m, least clearance 0.900 m, 0 iterations\n"
            "  1.000 1.000\n  9.000 1.000\n");
}

TEST_F(PlanVerb, TreeAndRawPathOnRequest) {
  const Json query = plan_json({"--start", "1,1", "--goal", "19,2", "--with-tree"})["queries"][0];
  EXPECT_GT(query["tree"].size(), 0U);
  EXPECT_EQ(query["tree"][0].size(), 4U);
  EXPECT_EQ(query["raw_path"].front(), query["path"].front());
  const Json raw =
      plan_json({"--start", "1,1", "--goal", "19,2", "--with-tree", "--no-smooth"})["queries"][0];
  EXPECT_EQ(raw["path"], raw["raw_path"]);
  EXPECT_EQ(raw["raw_path"], query["raw_path"]);
  EXPECT_LE(query["length_m"], raw["length_m"]);
}

TEST_F(PlanVerb, SameSeedSameBytesForAnyNumberOfThreads) {
  const std::string pairs =
      folder_.file("pairs.csv", "start_x,start_y,goal_x,goal_y\n1,1,19,9\n1,1,18,5\n8,9,11,2\n");
  const auto run = [&](const char* jobs, const char* seed) {
    return plan({"--queries", pairs, "--jobs", jobs, "--seed", seed, "--format", "json"}).out;
  };
  EXPECT_EQ(run("1", "3"), run("4", "3"));
  EXPECT_NE(run("1", "3"), run("1", "4"));
  EXPECT_EQ(Json::parse(run("2", "3"))["queries"].size(), 3U);
}

TEST_F(PlanVerb, ProvesThatThereIsNoWay) {
  const Json query =
      plan_json({"--start", "1,1", "--goal", "19,9", "--radius", "0.41", "--max-iterations", "200"},
                1)["queries"][0];
  EXPECT_EQ(query["solved"], false);
  EXPECT_EQ(query["reachable"], false);
  EXPECT_EQ(query["path"], Json::array());
  EXPECT_EQ(query["length_m"], nullptr);
  EXPECT_EQ(query["iterations"], 200);
  EXPECT_NE(query["reason"].get<std::string>().find("proved"), std::string::npos);
}

TEST_F(PlanVerb, SaysThatAWayExistsWhenThePlannerMissedIt) {
  const Json query =
      plan_json({"--start", "1,1", "--goal", "19,9", "--radius", "0.39", "--max-iterations", "3"},
                1)["queries"][0];
  EXPECT_EQ(query["reachable"], true);
  EXPECT_NE(query["reason"].get<std::string>().find("--max-iterations"), std::string::npos);
}

TEST_F(PlanVerb, NamesWhatIsInTheWayOfStartAndGoal) {
  const auto reason = [&](const char* start, const char* goal, const char* radius) {
    return plan_json({"--start", start, "--goal", goal, "--radius", radius},
                     1)["queries"][0]["reason"]
        .get<std::string>();
  };
  EXPECT_EQ(reason("2.5,6.5", "1,1", "0"), "start (2.5, 6.5) lies in obstacle 3 (building)");
  EXPECT_EQ(reason("1,1", "13,7.2", "0"), "goal (13, 7.2) lies in obstacle 5 (step)");
  EXPECT_EQ(reason("1,1", "21,1", "0"), "goal (21, 1) lies outside of the map's border");
  EXPECT_EQ(reason("1,1", "4,5.9", "0.3"),
            "goal (4, 5.9) is 0.100 m from obstacle 3 (building), too near for a robot of radius "
            "0.3 m");
  EXPECT_EQ(
      reason("1,0.1", "4,4", "0.3"),
      "start (1, 0.1) is 0.100 m from the map's border, too near for a robot of radius 0.3 m");
  EXPECT_EQ(reason("1,1", "4,4", "5.5"),
            "a robot of radius 5.5 m does not fit within the map's border, 20 m by 10 m");
}

TEST_F(PlanVerb, SamePointIsATrivialPath) {
  const Json query = plan_json({"--start", "1,1", "--goal", "1,1"})["queries"][0];
  EXPECT_EQ(query["solved"], true);
  EXPECT_EQ(query["length_m"], 0.0);
}

TEST_F(PlanVerb, ClearanceIsNullWhereNothingBlocks) {
  map_ = folder_.file("empty.txt", format_map(map10({})));
  EXPECT_EQ(plan_json({"--start", "1,1", "--goal", "9,9"})["queries"][0]["min_clearance_m"],
            nullptr);
}

TEST_F(PlanVerb, PassesViaPointsAndRamps) {
  const Json query = plan_json({"--start", "1,1", "--goal", "19,9", "--via", "1,9", "--via",
                                "ramp:12", "--via", "19,1"})["queries"][0];
  const auto path = path_of(query);
  const auto passes = [&](auto&& is_there) {
    return std::any_of(path.begin(), path.end(), is_there);
  };
  EXPECT_TRUE(passes([](Point p) { return p == Point{1, 9}; }));
  EXPECT_TRUE(passes([](Point p) { return p == Point{19, 1}; }));
  EXPECT_TRUE(passes([](Point p) { return Box({14, 1, 16, 3}).contains(p); }));
}

TEST_F(PlanVerb, RampsAreFreeAvoidedOrForced) {
  const auto crosses = [&](const char* ramps) {
    const auto query =
        plan_json({"--start", "13,2", "--goal", "17,2", "--ramps", ramps})["queries"][0];
    double nearest = HUGE_VAL;
    const auto path = path_of(query);
    for (std::size_t i = 1; i < path.size(); ++i) {
      nearest = std::min(
          nearest, distance({15, 2}, closest_point_on_segment({15, 2}, path[i - 1], path[i])));
    }
    return nearest < 1.0;
  };
  EXPECT_TRUE(crosses("free"));
  EXPECT_FALSE(crosses("avoid"));
  const auto query = plan_json({"--start", "11,5", "--goal", "19,5", "--ramps", "force"});
  EXPECT_GT(query["queries"][0]["length_m"], 8.94);  // straight: 8 m; over the ramp's edge: 8.944 m
  EXPECT_EQ(
      plan({"--start", "1,1", "--goal", "9,1", "--ramps", "avoid", "--via-ramp", "12"}).status, 2);
}

// A bench in each room, named; a statue in the courtyard nobody can enter.
Map site_with_names() {
  Map map = site();
  const auto add = [&](Obstacle obstacle, const char* name) {
    obstacle.semantic = obstacle.semantic.with_value("name", name);
    map.obstacles.push_back(std::move(obstacle));
  };
  add(box(21, 2, 2, 4, 2.5), "West bench");
  add(box(22, 17, 8, 19, 8.5), "Café");
  add(box(23, 3.5, 7.4, 3.7, 7.6), "Statue");
  return map;
}

class PlanBetweenNames : public PlanVerb {
 protected:
  PlanBetweenNames() { map_ = folder_.file("names.txt", format_map(site_with_names())); }
};

TEST_F(PlanBetweenNames, GoesToFreeGroundBesideThem) {
  for (const char* planner : {"balanced-rrt", "exact"}) {
    const Json query = plan_json({"--start", "West bench", "--goal", "Café", "--radius", "0.3",
                                  "--planner", planner})["queries"][0];
    EXPECT_EQ(query["solved"], true);
    EXPECT_EQ(query["start_name"], "West bench");
    EXPECT_EQ(query["goal_name"], "Café");
    EXPECT_NEAR(query["start"][0], 3.0, 1e-9);
    EXPECT_NEAR(query["start"][1], 2.0 - 0.305, 1e-9);
    EXPECT_EQ(query["path"].back(), query["goal"]);
  }
  const ProgramRun run = plan({"--start", "West bench", "--goal", "1,9"});
  EXPECT_EQ(run.out.substr(0, 37), "'West bench' (3, 1.995) to (1, 9): pa") << run.out;
}

TEST_F(PlanBetweenNames, TakesThemFromQueriesBesidePoints) {
  const Json point = plan_json({"--start", "West bench", "--goal", "Café"})["queries"][0];
  const auto answers = [&](const std::string& text) {
    return plan_json({"--queries", folder_.file("q.csv", text)})["queries"];
  };
  EXPECT_EQ(answers("West bench, Café\n")[0]["goal"], point["goal"]);
  const Json mixed =
      answers("goal,start,start_x,start_y,goal_x,goal_y\nCafé,,1,9,,\n,West bench,,,9,1\n");
  EXPECT_EQ(mixed[0]["start"], Json::array({1.0, 9.0}));
  EXPECT_EQ(mixed[0]["goal_name"], "Café");
  EXPECT_EQ(mixed[1]["start"], point["start"]);
  EXPECT_EQ(mixed[1]["goal"], Json::array({9.0, 1.0}));
}

TEST_F(PlanBetweenNames, PassesThemAsViaPoints) {
  const Json query = plan_json({"--start", "1,1", "--goal", "19,1", "--via", "Café"})["queries"][0];
  bool passes = false;
  for (const Point p : path_of(query)) passes = passes || distance(p, {18, 8}) < 1.2;
  EXPECT_TRUE(passes);
}

TEST_F(PlanBetweenNames, UnknownOnesAreAnsweredWithSimilarOnesAndAll) {
  const ProgramRun run = plan({"--start", "West bank", "--goal", "Café"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("no place named 'West bank'; did you mean 'West bench'?"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("Its places: 'West bench', 'Café', 'Statue'"), std::string::npos);
  EXPECT_EQ(plan({"--queries", folder_.file("q.csv", "West bank,Café\n")}).status, 2);
  map_ = folder_.file("site.txt", format_map(site_));
  EXPECT_NE(plan({"--start", "A", "--goal", "B"}).err.find("none of its obstacles has a name"),
            std::string::npos);
}

TEST_F(PlanBetweenNames, SaysWhereThereIsNoRoomAndNoWay) {
  const auto reason = [&](const char* goal, const char* radius) {
    const Json query =
        plan_json({"--start", "1,1", "--goal", goal, "--radius", radius, "--planner", "exact"},
                  1)["queries"][0];
    EXPECT_EQ(query["reachable"], false);
    return query["reason"].get<std::string>();
  };
  EXPECT_NE(reason("Statue", "0.3").find("proved"), std::string::npos);
  EXPECT_EQ(reason("Statue", "0.6"), "goal: there is no room for the robot within 1 m of 'Statue'");
}

TEST_F(PlanVerb, WrongUsageIsStatusTwoAndNamesTheOption) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"--start", "1,1"},
      {"--start", "1,1", "--goal", "nan,2"},
      {"--start", "1,1", "--goal", "inf,2"},
      {"--start", "1", "--goal", "2,2"},
      {"--start", "1,1", "--goal", "2,2", "--radius", "-0.1"},
      {"--start", "1,1", "--goal", "2,2", "--radius", "nan"},
      {"--start", "1,1", "--goal", "2,2", "--planner", "magic"},
      {"--start", "1,1", "--goal", "2,2", "--seed", "-1"},
      {"--start", "1,1", "--goal", "2,2", "--max-iterations", "0"},
      {"--start", "1,1", "--goal", "2,2", "--goal-bias", "1"},
      {"--start", "1,1", "--goal", "2,2", "--ramps", "maybe"},
      {"--start", "1,1", "--goal", "2,2", "--via", "ramp:x"},
      {"--start", "1,1", "--goal", "2,2", "--via-ramp", "99"},
      {"--start", "1,1", "--goal", "2,2", "--format", "xml"},
      {"--start", "1,1", "--goal", "2,2", "--with-tree"},
      {"--start", "1,1", "--goal", "2,2", "--smooth", "--no-smooth"},
      {"--start", "1,1", "--goal", "2,2", "--queries", "x.csv"},
  };
  for (const auto& options : wrong) {
    const ProgramRun run = plan(options);
    EXPECT_EQ(run.status, 2) << testing::PrintToString(options);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err, "");
  }
}

TEST_F(PlanVerb, UnreadableInputsAreStatusThree) {
  const auto query_file = [&](const std::string& text) {
    return plan({"--queries", folder_.file("q.csv", text)});
  };
  EXPECT_EQ(plan({"--queries", folder_.path("none.csv")}).status, 3);
  const ProgramRun bad = query_file("start_x,start_y,goal_x,goal_y\n1,2,3,4\n1,2,nan,4\n");
  EXPECT_EQ(bad.status, 3);
  EXPECT_NE(bad.err.find("q.csv:3: field 3: goal_x: 'nan' is not a finite number"),
            std::string::npos)
      << bad.err;
  EXPECT_EQ(query_file("1,2,3\n").status, 3);
  EXPECT_EQ(query_file("start_x,start_y,goal_x\n1,2,3\n").status, 3);
  map_ = folder_.file("broken.txt", format_map(site_) + "obstacle; 99; 1; 4; half\n");
  const ProgramRun broken = plan({"--start", "1,1", "--goal", "2,2"});
  EXPECT_EQ(broken.status, 3);
  EXPECT_NE(broken.err.find("broken.txt:"), std::string::npos);
  map_ = folder_.path("none.txt");
  EXPECT_EQ(plan({"--start", "1,1", "--goal", "2,2"}).status, 3);
}

TEST_F(PlanVerb, ColumnsOfQueriesMayStandInAnyOrder) {
  const std::string pairs =
      folder_.file("q.csv", "# pairs\n\ngoal_x,goal_y,name,start_x,start_y\r\n9,1,a,1,1\r\n");
  const Json answer = plan_json({"--queries", pairs});
  EXPECT_EQ(answer["queries"][0]["start"], Json::array({1.0, 1.0}));
  EXPECT_EQ(answer["queries"][0]["goal"], Json::array({9.0, 1.0}));
}

}  // namespace
}  // namespace mapwright
