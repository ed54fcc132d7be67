// Lengths that others have published.
#include <gtest/gtest.h>

#include <fstream>

#include "bench/support/grid_world.hpp"
#include "bench/support/polygonal_world.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "tests/support/data.hpp"

namespace mapwright::navcore {
namespace {

TEST(PublishedOptima, AuroraIsMetByEveryQuery) {
  const std::string folder = "4_planning/polygonal_euclid/";
  MAPWRIGHT_REQUIRE_REAL_DATA(folder + "aurora.geojson");
  std::ifstream world(test::real_data(folder + "aurora.geojson"));
  std::ifstream csv(test::real_data(folder + "aurora.queries.csv"));
  const auto planner = ExactPlanner::build(bench::read_polygonal_world(world), {});
  ASSERT_TRUE(planner.has_value());
  const auto queries = bench::read_published_queries(csv);
  ASSERT_EQ(queries.size(), 2990U);
  ExactWorkspace workspace;
  for (const auto& query : queries) {
    const ExactAnswer answer = planner->plan(query.start, query.goal, workspace);
    ASSERT_EQ(answer.verdict, Verdict::kReachable);
    EXPECT_NEAR(answer.length_m, query.optimum_m, 1e-4 * query.optimum_m);
  }
}

// Grid paths take straight and diagonal steps; the shortest path of all is never longer.
TEST(PublishedOptima, NoCityPathIsLongerThanItsGridPath) {
  for (const std::string city : {"Berlin_0_256", "Boston_0_256", "Paris_1_256"}) {
    const std::string path = "4_planning/movingai_city/" + city + ".map";
    MAPWRIGHT_REQUIRE_REAL_DATA(path);
    std::ifstream grid(test::real_data(path)), scenarios(test::real_data(path + ".scen"));
    const auto planner = ExactPlanner::build(bench::read_grid_world(grid), {});
    ASSERT_TRUE(planner.has_value());
    ExactWorkspace workspace;
    for (const auto& query : bench::read_scenarios(scenarios)) {
      const ExactAnswer answer = planner->plan(query.start, query.goal, workspace);
      ASSERT_EQ(answer.verdict, Verdict::kReachable) << city;
      ASSERT_LE(answer.length_m, query.optimum_m + 1e-5) << city;  // published to 1e-5
    }
  }
}

}  // namespace
}  // namespace mapwright::navcore
