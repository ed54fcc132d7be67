// Maps for tests of checks, in a few words.
#pragma once

#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "validators/validator.hpp"

namespace mapwright::test {

using Points = std::vector<Point>;

inline Obstacle chain(std::int64_t id, ShapeType type, const Points& points, double height_m = 3.0,
                      const char* semantic = "test", InOut in_out = InOut::kOutdoor) {
  Obstacle obstacle{id, type, semantic, {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    obstacle.segments.push_back({points[i], points[i + 1], height_m, in_out, "wall"});
  }
  return obstacle;
}

/// A closed polygon; the first point is not repeated.
inline Obstacle ring(std::int64_t id, Points points, const char* semantic = "test",
                     InOut in_out = InOut::kOutdoor) {
  points.push_back(points.front());
  return chain(id, ShapeType::kClosedPolygon, points, 3.0, semantic, in_out);
}

inline Points corners(const Box& b) {
  return {{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}};
}

inline Points reversed(Points points) {
  return {points.rbegin(), points.rend()};
}

inline Obstacle solid(std::int64_t id, const Box& b) {
  return ring(id, corners(b));
}

inline Obstacle hollow(std::int64_t id, const Box& b, const char* semantic = "test",
                       InOut in_out = InOut::kOutdoor) {
  return ring(id, reversed(corners(b)), semantic, in_out);
}

inline Obstacle wall(std::int64_t id, const Points& points) {
  return chain(id, ShapeType::kOpenPolygon, points);
}

/// What validation finds in a map of these obstacles within (-50, -50) … (50, 50): codes and whom
/// they blame, "G107:3 " for obstacle 3, "G108:3.2 " for its second segment.
inline std::string found_in(std::vector<Obstacle> obstacles) {
  const Map map{{-50.0, 50.0, 50.0, -50.0}, std::move(obstacles)};
  std::string text;
  for (const auto& f : validators::validate(read_map(format_map(map)))) {
    text += std::string(finding_type(f.code).id) + ":";
    if (f.obstacle) text += std::to_string(*f.obstacle);
    if (f.segment) text += "." + std::to_string(*f.segment);
    text += " ";
  }
  return text;
}

}  // namespace mapwright::test
