// Lengths that others have published.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mapcore/geometry/orientation.hpp"
#include "navcore/exact/exact_planner.hpp"
#include "tests/navcore/shapes.hpp"
#include "tests/support/data.hpp"

namespace mapwright::navcore {
namespace {

// The world's polygons are free: outer rings become clockwise outlines, holes solid ones.
Map polygonal_world(const std::filesystem::path& path, double side_m) {
  const auto world = nlohmann::json::parse(std::ifstream(path));
  Map map{{-1.0, side_m + 1.0, side_m + 1.0, -1.0}, {}};
  std::int64_t id = 1;
  for (const auto& feature : world["features"]) {
    bool is_outer = true;
    for (const auto& ring : feature["geometry"]["coordinates"]) {
      std::vector<Point> points;
      for (const auto& p : ring) points.push_back({p[0], p[1]});
      points.pop_back();
      if ((signed_area_m2(points) > 0.0) == is_outer) std::reverse(points.begin(), points.end());
      map.obstacles.push_back(test::outline(id++, points, 1.0));
      is_outer = false;
    }
  }
  return map;
}

struct PublishedQuery {
  Point start, goal;
  double optimum_m = 0.0;
};

std::vector<PublishedQuery> published_queries(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  std::vector<PublishedQuery> queries;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    PublishedQuery query;
    fields >> query.start.x >> query.start.y >> query.goal.x >> query.goal.y >> query.optimum_m;
    queries.push_back(query);
  }
  return queries;
}

TEST(PublishedOptima, AuroraIsMetByEveryQuery) {
  const std::string folder = "4_planning/polygonal_euclid/";
  MAPWRIGHT_REQUIRE_REAL_DATA(folder + "aurora.geojson");
  const Map map = polygonal_world(test::real_data(folder + "aurora.geojson"), 1024.0);
  const auto planner = ExactPlanner::build(map, {});
  ASSERT_TRUE(planner.has_value());
  const auto queries = published_queries(test::real_data(folder + "aurora.queries.csv"));
  ASSERT_EQ(queries.size(), 2990U);
  ExactWorkspace workspace;
  for (const auto& query : queries) {
    const ExactAnswer answer = planner->plan(query.start, query.goal, workspace);
    ASSERT_EQ(answer.verdict, Verdict::kReachable);
    EXPECT_NEAR(answer.length_m, query.optimum_m, 1e-4 * query.optimum_m);
  }
}

}  // namespace
}  // namespace mapwright::navcore
