// Where a map can be broken, and how its parts are moved.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tests/validators/mutators.hpp"

namespace mapwright::test {

using Answer = std::optional<Expected>;

template <class Suits>
std::optional<std::size_t> any_obstacle(const Map& map, Random& random, const Suits& suits) {
  std::vector<std::size_t> suitable;
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    if (suits(map.obstacles[i])) suitable.push_back(i);
  }
  if (suitable.empty()) return std::nullopt;
  return suitable[random.below(suitable.size())];
}

inline bool is_ring(const Obstacle& o) {
  return is_closed(o.shape_type);
}
inline bool is_polygon(const Obstacle& o) {
  return o.shape_type == ShapeType::kClosedPolygon;
}
inline bool is_rectangle(const Obstacle& o) {
  return is_polygon(o) && o.segments.size() == 4;
}
inline bool is_wall(const Obstacle& o) {
  return is_open_chain(o.shape_type);
}
inline bool is_stairs(const Obstacle& o) {
  return o.shape_type == ShapeType::kStairs && o.segments.size() >= 5;
}
inline bool is_ramp(const Obstacle& o) {
  return o.shape_type == ShapeType::kRamp;
}
inline bool is_any(const Obstacle&) {
  return true;
}

inline std::size_t any_segment(const Obstacle& o, Random& random) {
  return random.below(o.segments.size());
}

inline void set_vertex(Obstacle& o, std::size_t k, Point p) {
  const std::size_t n = o.segments.size();
  o.segments[k].a = p;
  if (k > 0 || is_ring(o)) o.segments[(k + n - 1) % n].b = p;
}

// The first of the segments that the vertex k belongs to.
inline std::size_t first_at_vertex(const Obstacle& o, std::size_t k) {
  if (k == 0) return 1;
  return is_ring(o) || is_wall(o) ? k : k + 1;
}

inline void reverse(Obstacle& o) {
  std::reverse(o.segments.begin(), o.segments.end());
  for (auto& s : o.segments) std::swap(s.a, s.b);
}

inline std::vector<std::size_t> steps_of(const Obstacle& stairs) {
  std::vector<std::size_t> steps;
  for (std::size_t k = 0; k < stairs.segments.size(); ++k) {
    if (stairs.segments[k].height_m > 0.0) steps.push_back(k);
  }
  return steps;
}

inline std::size_t top_of(const Obstacle& stairs) {
  return stairs.segments.front().height_m == 0.0 ? 0 : stairs.segments.size() - 1;
}

// Appends an obstacle under a new id.
inline Expected add_obstacle(Map& map, ShapeType type, const std::vector<Point>& points,
                             double height_m) {
  Obstacle added{map.obstacles.back().id + 1, type, "added", {}};
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    added.segments.push_back({points[k], points[k + 1], height_m, InOut::kOutdoor, "wall"});
  }
  map.obstacles.push_back(std::move(added));
  return Expected{map.obstacles.size() - 1, {}};
}

}  // namespace mapwright::test
