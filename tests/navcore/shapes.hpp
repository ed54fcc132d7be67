// Obstacles for tests, in a few words.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mapcore/map.hpp"
#include "mapcore/random.hpp"

namespace mapwright::test {

inline Obstacle chain(std::int64_t id, ShapeType type, const std::vector<Point>& points,
                      double height_m) {
  Obstacle obstacle{id, type, "test", {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    obstacle.segments.push_back({points[i], points[i + 1], height_m, InOut::kOutdoor, {}});
  }
  return obstacle;
}

/// A closed outline; the points are not repeated.
inline Obstacle outline(std::int64_t id, std::vector<Point> points, double height_m) {
  points.push_back(points.front());
  return chain(id, ShapeType::kClosedPolygon, points, height_m);
}

inline Obstacle box(std::int64_t id, const Box& b, double height_m) {
  return outline(id,
                 {{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}},
                 height_m);
}

inline Obstacle wall(std::int64_t id, Point a, Point b, double height_m) {
  return chain(id, ShapeType::kOpenPolygon, {a, b}, height_m);
}

/// A frame of its own: where an obstacle drawn around the origin is put.
struct Placement {
  Point at;
  double turn_rad = 0.0;

  Point operator()(Point p) const {
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    return {at.x + c * p.x - s * p.y, at.y + s * p.x + c * p.y};
  }
};

inline double to_millimetres(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

/// Stairs that rise along +y from y = 0: steps 0.3 m apart, each `rise_m` higher, from x = 0 to
/// `width_m`, and the top.
inline Obstacle stairs(std::int64_t id, const Placement& place, int steps, double rise_m,
                       double width_m) {
  Obstacle obstacle{id, ShapeType::kStairs, "step", {}};
  const auto add = [&](Point a, Point b, double height_m) {
    obstacle.segments.push_back({place(a), place(b), height_m, InOut::kOutdoor, {}});
  };
  const auto y = [](int step) { return to_millimetres(0.3 * step); };
  for (int i = 0; i < steps; ++i) {
    add({0, y(i)}, {width_m, y(i)}, to_millimetres(rise_m * (i + 1)));
  }
  add({width_m, y(steps)}, {0, y(steps)}, 0.0);
  return obstacle;
}

/// A ramp that rises along +y from y = 0 at `slope` (metres a metre).
inline Obstacle ramp(std::int64_t id, const Placement& place, double width_m, double length_m,
                     double slope) {
  Obstacle obstacle = outline(
      id, {place({0, 0}), place({width_m, 0}), place({width_m, length_m}), place({0, length_m})},
      0.0);
  obstacle.shape_type = ShapeType::kRamp;
  const Point uphill = place({0, 1}) - place({0, 0});
  const double scale = 1.0 / std::hypot(1.0, slope);
  const Normal normal{-slope * uphill.x * scale, -slope * uphill.y * scale, scale};
  obstacle.semantic = Semantic("ramp").with_value(semantic_key::kNormal, format_normal(normal));
  return obstacle;
}

/// A square of 60 m full of everything: blocks of many heights, some with shared corners, thin
/// walls, stairs, ramps, in millimetres like a map from a file.
inline Map cluttered_square(std::uint64_t seed) {
  Random random(seed);
  Map map{{0.0, 60.0, 60.0, 0.0}, {}};
  const auto place = [&] {
    return Placement{{random.uniform(3, 57), random.uniform(3, 57)}, random.uniform(0, 6.3)};
  };
  std::int64_t id = 1;
  for (int i = 0; i < 25; ++i) {
    const auto at = place();
    const double w = random.uniform(0.2, 5), h = random.uniform(0.2, 5);
    map.obstacles.push_back(
        outline(id++, {at({0, 0}), at({w, 0}), at({w, h}), at({w / 2, h / 2}), at({0, h})},
                random.uniform(0.1, 3)));
  }
  for (int i = 0; i < 10; ++i) {
    const auto at = place();
    map.obstacles.push_back(chain(id++, ShapeType::kOpenPolygon,
                                  {at({0, 0}), at({3, 0.4}), at({4, 3}), at({4, 3.01})},
                                  random.uniform(0.1, 3)));
  }
  for (int i = 0; i < 8; ++i) {
    map.obstacles.push_back(stairs(id++, place(), 1 + static_cast<int>(random.below(9)),
                                   random.uniform(0.1, 0.22), random.uniform(1, 6)));
    map.obstacles.push_back(ramp(id++, place(), random.uniform(1, 4), random.uniform(2, 12),
                                 random.uniform(0.03, 0.3)));
  }
  for (auto& obstacle : map.obstacles) {
    for (auto& s : obstacle.segments) {
      s = {{to_millimetres(s.a.x), to_millimetres(s.a.y)},
           {to_millimetres(s.b.x), to_millimetres(s.b.y)},
           to_millimetres(s.height_m),
           s.in_out,
           s.semantic};
    }
  }
  return map;
}

/// Streets of a small town on whole metres: collinear walls, corners on grid lines, rays that run
/// along walls and through corners.
inline Map rectilinear_town() {
  Map map{{0.0, 60.0, 60.0, 0.0}, {}};
  std::int64_t id = 1;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double x = 10.0 * i + 2, y = 10.0 * j + 2;
      map.obstacles.push_back(box(id++, {x, y, x + 4, y + 5}, 0.5 * ((i + j) % 4)));
      map.obstacles.push_back(wall(id++, {x + 6, y}, {x + 6, y + 7}, 1.0));
      map.obstacles.push_back(stairs(id++, {{x + 4.5, y - 1}, 0.0}, 4, 0.2, 1));
      map.obstacles.push_back(ramp(id++, {{x, y + 5.5}, 0.0}, 3, 2, 0.4));
    }
  }
  return map;
}

}  // namespace mapwright::test
