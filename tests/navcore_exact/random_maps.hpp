// Small maps full of coincidences: shared corners, collinear walls, overlaps, walls that touch.
#pragma once

#include "mapcore/random.hpp"
#include "tests/navcore/shapes.hpp"

namespace mapwright::test {

inline constexpr double kSide_m = 20.0;

inline Point whole_point(Random& random) {
  return {static_cast<double>(random.below(21)), static_cast<double>(random.below(21))};
}

inline Obstacle whole_box(std::int64_t id, Random& random) {
  const Point p = whole_point(random);
  const auto w = static_cast<double>(1 + random.below(6)),
             h = static_cast<double>(1 + random.below(6));
  return box(id, {p.x, p.y, std::min(p.x + w, kSide_m), std::min(p.y + h, kSide_m)}, 1.0);
}

/// A wall along an axis or a diagonal: such walls cross at halves of whole metres.
inline Obstacle straight_wall(std::int64_t id, Random& random) {
  const Point p = whole_point(random);
  const auto length_m = static_cast<double>(1 + random.below(7));
  const Point directions[] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  return wall(id, p, p + length_m * directions[random.below(4)], 1.0);
}

inline Obstacle whole_triangle(std::int64_t id, Random& random) {
  Point a = whole_point(random), b = whole_point(random);
  const Point c = whole_point(random);
  if (cross(b - a, c - a) < 0.0) std::swap(a, b);
  return outline(id, {a, b, c}, 1.0);
}

inline bool has_area(const Obstacle& obstacle) {
  return max_height_m(obstacle) > 0.0 && extent(obstacle).width() > 0.0 &&
         extent(obstacle).height() > 0.0;
}

/// `kind` 0: boxes and walls, which overlap and cross at points of the grid; 1: also triangles.
inline Map whole_map(Random& random, int kind) {
  Map map{{0.0, kSide_m, kSide_m, 0.0}, {}};
  const auto count = 3 + random.below(10);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::int64_t>(i + 1);
    const auto draw = random.below(kind == 0 ? 5 : 7);
    const Obstacle obstacle = draw < 3   ? whole_box(id, random)
                              : draw < 5 ? straight_wall(id, random)
                                         : whole_triangle(id, random);
    if (obstacle.shape_type == ShapeType::kOpenPolygon || has_area(obstacle)) {
      map.obstacles.push_back(obstacle);
    }
  }
  return map;
}

/// Boxes and walls so close that a disc often finds no way.
inline Map crowded_map(Random& random) {
  Map map = whole_map(random, 0);
  for (int i = 0; i < 2; ++i) {
    const Map more = whole_map(random, 0);
    map.obstacles.insert(map.obstacles.end(), more.obstacles.begin(), more.obstacles.end());
  }
  return map;
}

}  // namespace mapwright::test
