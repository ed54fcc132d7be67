#include "bench/support/polygonal_world.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::bench {
namespace {

std::vector<Point> ring_points(const nlohmann::json& ring) {
  std::vector<Point> points;
  for (const auto& p : ring) points.push_back({p.at(0), p.at(1)});
  points.pop_back();
  return points;
}

Obstacle outline(std::int64_t id, const std::vector<Point>& points) {
  Obstacle obstacle{id, ShapeType::kClosedPolygon, "world", {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    obstacle.segments.push_back(
        {points[i], points[(i + 1) % points.size()], 1.0, InOut::kOutdoor, {}});
  }
  return obstacle;
}

}  // namespace

Map read_polygonal_world(std::istream& geojson) {
  const auto world = nlohmann::json::parse(geojson);
  Map map;
  for (const auto& feature : world.at("features")) {
    bool is_outer = true;
    for (const auto& ring : feature.at("geometry").at("coordinates")) {
      std::vector<Point> points = ring_points(ring);
      if ((signed_area_m2(points) > 0.0) == is_outer) std::reverse(points.begin(), points.end());
      map.obstacles.push_back(outline(static_cast<std::int64_t>(map.obstacles.size() + 1), points));
      is_outer = false;
    }
  }
  const Box box = extent(map).inflated(1.0);
  map.border = {box.min_x, box.max_y, box.max_x, box.min_y};
  return map;
}

std::vector<PublishedQuery> read_published_queries(std::istream& csv) {
  std::string line;
  std::getline(csv, line);
  std::vector<PublishedQuery> queries;
  while (std::getline(csv, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    PublishedQuery query;
    fields >> query.start.x >> query.start.y >> query.goal.x >> query.goal.y >> query.optimum_m;
    queries.push_back(query);
  }
  return queries;
}

}  // namespace mapwright::bench
