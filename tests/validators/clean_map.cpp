#include <algorithm>

#include "bench/support/campus_generator.hpp"
#include "tests/validators/mutators.hpp"

namespace mapwright::test {
namespace {

constexpr double kSide_m = 100.0;

// Puts obstacles to the right of the generated campus.
class Annex {
 public:
  explicit Annex(Map& map) : map_(map), next_id_(map.obstacles.back().id + 1) {
    map_.border.right += 50.0;
  }

  std::int64_t chain(ShapeType type, const std::vector<Point>& points, double height_m,
                     const char* semantic, InOut in_out = InOut::kOutdoor) {
    Obstacle obstacle{next_id_++, type, semantic, {}};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      obstacle.segments.push_back(
          {placed(points[i]), placed(points[i + 1]), height_m, in_out, "wall"});
    }
    map_.obstacles.push_back(std::move(obstacle));
    return map_.obstacles.back().id;
  }

  std::int64_t solid(const Box& b, const char* semantic) {
    return chain(ShapeType::kClosedPolygon,
                 {{b.min_x, b.min_y},
                  {b.max_x, b.min_y},
                  {b.max_x, b.max_y},
                  {b.min_x, b.max_y},
                  {b.min_x, b.min_y}},
                 3.0, semantic);
  }

  std::int64_t hollow(const Box& b, const std::string& semantic) {
    return chain(ShapeType::kClosedPolygon,
                 {{b.min_x, b.min_y},
                  {b.min_x, b.max_y},
                  {b.max_x, b.max_y},
                  {b.max_x, b.min_y},
                  {b.min_x, b.min_y}},
                 3.0, semantic.c_str());
  }

  // Rising along +y from (x, y).
  void stairs(Point foot, int steps, bool top_down) {
    Obstacle obstacle{next_id_++, ShapeType::kStairs, "stairs", {}};
    for (int i = 0; i < steps; ++i) {
      const double y = foot.y + 0.3 * i;
      obstacle.segments.push_back({placed({foot.x, y}), placed({foot.x + 3.0, y}), 0.17 * (i + 1),
                                   InOut::kOutdoor, "step"});
    }
    const double top = foot.y + 0.3 * steps;
    obstacle.segments.push_back(
        {placed({foot.x + 3.0, top}), placed({foot.x, top}), 0.0, InOut::kOutdoor, "step"});
    if (top_down) std::reverse(obstacle.segments.begin(), obstacle.segments.end());
    map_.obstacles.push_back(std::move(obstacle));
  }

 private:
  Point placed(Point p) const { return {kSide_m + p.x, p.y}; }

  Map& map_;
  std::int64_t next_id_;
};

// Whether the laser sees a thing must not hang on the last decimal.
void lift_above_the_laser(Map& map) {
  for (auto& obstacle : map.obstacles) {
    if (!obstacle.semantic.has_label("bench")) continue;
    for (auto& segment : obstacle.segments) segment.height_m = 0.6;
  }
}

}  // namespace

Map clean_map(std::uint64_t seed) {
  Map map = bench::generate_campus({kSide_m, 300, seed});
  lift_above_the_laser(map);
  Annex annex(map);
  const auto building = annex.solid({5, 5, 25, 25}, "building");
  annex.hollow({10, 10, 20, 20}, "courtyard,inner_of=" + std::to_string(building));
  annex.solid({12, 12, 13, 13}, "fountain");
  annex.solid({25, 5, 35, 15}, "annex");
  annex.hollow({5, 30, 45, 50}, "room");
  annex.solid({8, 33, 10, 35}, "table");
  annex.chain(ShapeType::kOpenPolygon, {{30, 15}, {28, 15}}, 1.0, "railing");
  annex.chain(ShapeType::kOpenPolygon, {{25, 8}, {25, 6}}, 1.0, "party wall");
  annex.chain(ShapeType::kOpenPolygon, {{50, 90}, {50, 80}}, 2.0, "fence");
  annex.chain(ShapeType::kOpenPolygon, {{30, 20}, {40, 20}, {40, 25}}, 2.0, "fence");
  annex.stairs({5, 60}, 6, false);
  annex.stairs({15, 60}, 6, true);
  annex.chain(ShapeType::kRamp, {{25, 60}, {35, 60}, {35, 63}, {25, 63}, {25, 60}}, 0.0,
              "ramp,normal=-0.0995:0:0.995");
  return map;
}

}  // namespace mapwright::test
