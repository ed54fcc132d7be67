// Small maps written down in tests.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "mapcore/map.hpp"

namespace mapwright::test {

// Apart from functions of these names in other headers of tests.
inline namespace hand_made {

inline Segment segment(Point a, Point b, double height_m) {
  return {a, b, height_m, InOut::kOutdoor, "wall"};
}

/// A closed polygon through the points, in the order given (counter-clockwise = solid).
inline Obstacle ring(std::int64_t id, const std::vector<Point>& points, double height_m = 3.0,
                     const std::string& semantic = "building") {
  Obstacle obstacle{id, ShapeType::kClosedPolygon, semantic, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    obstacle.segments.push_back(segment(points[i], points[(i + 1) % points.size()], height_m));
  }
  return obstacle;
}

inline std::vector<Point> rectangle(double x1, double y1, double x2, double y2) {
  return {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}};
}

inline std::vector<Point> reversed(std::vector<Point> points) {
  return {points.rbegin(), points.rend()};
}

/// A solid box.
inline Obstacle box(std::int64_t id, double x1, double y1, double x2, double y2,
                    double height_m = 3.0) {
  return ring(id, rectangle(x1, y1, x2, y2), height_m);
}

/// A courtyard, or the inside of a room.
inline Obstacle hollow(std::int64_t id, double x1, double y1, double x2, double y2,
                       const std::string& semantic = "room") {
  return ring(id, reversed(rectangle(x1, y1, x2, y2)), 3.0, semantic);
}

/// An open wall through the points.
inline Obstacle wall(std::int64_t id, const std::vector<Point>& points, double height_m = 2.0) {
  Obstacle obstacle{id, ShapeType::kOpenPolygon, "wall", {}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    obstacle.segments.push_back(segment(points[i - 1], points[i], height_m));
  }
  return obstacle;
}

/// Stairs between x1 and x2 that rise towards +y in steps of 0.3 m by 0.2 m, bottom-up as in the
/// report's prose: steps at y, y + 0.3, …, the closing segment last.
inline Obstacle stairs(std::int64_t id, double x1, double x2, double y, int steps) {
  Obstacle obstacle{id, ShapeType::kStairs, "step", {}};
  for (int i = 0; i < steps; ++i) {
    const double step_y = y + 0.3 * i;
    obstacle.segments.push_back(segment({x1, step_y}, {x2, step_y}, 0.2 * (i + 1)));
  }
  const double top_y = y + 0.3 * steps;
  obstacle.segments.push_back(segment({x2, top_y}, {x1, top_y}, 0.0));
  return obstacle;
}

/// The same flight in the order of the report's sample: closing segment first, then top-down.
inline Obstacle stairs_top_down(std::int64_t id, double x1, double x2, double y, int steps) {
  Obstacle obstacle = stairs(id, x1, x2, y, steps);
  obstacle.segments = {obstacle.segments.rbegin(), obstacle.segments.rend()};
  return obstacle;
}

/// A ramp that rises towards +x.
inline Obstacle ramp(std::int64_t id, double x1, double y1, double x2, double y2) {
  Obstacle obstacle = ring(id, rectangle(x1, y1, x2, y2), 0.0, "ramp,normal=-0.08:0:0.9968");
  obstacle.shape_type = ShapeType::kRamp;
  return obstacle;
}

inline Map map(const Border& border, std::vector<Obstacle> obstacles) {
  return {border, std::move(obstacles)};
}

/// Border 0…10 in both directions.
inline Map map10(std::vector<Obstacle> obstacles) {
  return map({0.0, 10.0, 10.0, 0.0}, std::move(obstacles));
}

}  // namespace hand_made
}  // namespace mapwright::test
