#include "bench/support/grid_world.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

namespace mapwright::bench {
namespace {

bool is_free_cell(char cell) {
  return cell == '.' || cell == 'G' || cell == 'S';
}

Obstacle box(std::int64_t id, const Box& b) {
  const Point corners[] = {
      {b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}};
  Obstacle obstacle{id, ShapeType::kClosedPolygon, "cells", {}};
  for (int i = 0; i < 4; ++i) {
    obstacle.segments.push_back({corners[i], corners[(i + 1) % 4], 1.0, InOut::kOutdoor, {}});
  }
  return obstacle;
}

void add_runs(const std::string& row, double y, Map& map) {
  for (std::size_t from = 0; from < row.size(); ++from) {
    if (is_free_cell(row[from])) continue;
    std::size_t to = from;
    while (to < row.size() && !is_free_cell(row[to])) ++to;
    const auto id = static_cast<std::int64_t>(map.obstacles.size() + 1);
    map.obstacles.push_back(
        box(id, {static_cast<double>(from), y, static_cast<double>(to), y + 1.0}));
    from = to;
  }
}

}  // namespace

Map read_grid_world(std::istream& in) {
  std::string type, octile, height_word, width_word, map_word, row;
  std::size_t height = 0, width = 0;
  in >> type >> octile >> height_word >> height >> width_word >> width >> map_word;
  if (!in || type != "type" || map_word != "map") throw std::runtime_error("not a grid map");
  Map map{{0.0, static_cast<double>(height), static_cast<double>(width), 0.0}, {}};
  for (std::size_t y = 0; y < height && in >> row; ++y) add_runs(row, static_cast<double>(y), map);
  return map;
}

std::vector<PublishedQuery> read_scenarios(std::istream& in) {
  std::string line;
  std::getline(in, line);
  std::vector<PublishedQuery> queries;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::string bucket, name, width, height;
    PublishedQuery query;
    fields >> bucket >> name >> width >> height;
    fields >> query.start.x >> query.start.y >> query.goal.x >> query.goal.y >> query.optimum_m;
    query.start = query.start + Point{0.5, 0.5};
    query.goal = query.goal + Point{0.5, 0.5};
    queries.push_back(query);
  }
  return queries;
}

}  // namespace mapwright::bench
