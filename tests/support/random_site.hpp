// Generated maps as sites have them, and as hands leave them: for tests of export, crop and merge.
#pragma once

#include <string>
#include <vector>

#include "mapcore/angle.hpp"
#include "mapcore/map.hpp"
#include "mapcore/random.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright::test {

struct RandomSiteOptions {
  double half_side_m = 200.0;
  double resolution_m = 0.001;
  bool sound = false;  ///< without crossed outlines, odd ids and empty obstacles
};

/// Outlines with courtyards, rooms, walls with doors, stairs, ramps, curves; unless `sound` also
/// bow-ties, chains that do not join, empty obstacles, ids used twice, and semantic strings of any
/// length. Numbers are multiples of the resolution.
class RandomSite {
 public:
  RandomSite(Random& random, RandomSiteOptions options) : random_(random), options_(options) {}

  Map make() {
    const double side = options_.half_side_m;
    map_.border = {-side - random_.uniform(1, 3), side + 2.0, side + 1.5, -side - 1.0};
    const auto plots = 3 + random_.below(10);
    for (std::uint64_t i = 0; i < plots; ++i) add_something();
    if (!options_.sound) spoil();
    return quantized(map_, {options_.resolution_m});
  }

 private:
  Point somewhere(double margin_m) {
    const double reach = options_.half_side_m - margin_m;
    return {random_.uniform(-reach, reach), random_.uniform(-reach, reach)};
  }

  Obstacle& add(ShapeType type, const std::string& label) {
    map_.obstacles.emplace_back();
    auto& obstacle = map_.obstacles.back();
    obstacle.id = next_id_ += 1 + static_cast<std::int64_t>(random_.below(3));
    obstacle.shape_type = type;
    obstacle.semantic = semantic(label);
    return obstacle;
  }

  std::string semantic(const std::string& label) {
    std::string text = label;
    if (random_.below(2) == 0) text += ",name=Plaça de l'Àgora " + std::to_string(random_.below(9));
    if (random_.below(4) == 0) text += ", level = -1";
    if (random_.below(4) == 0) text += ",建物,x=\"1,5\"";
    if (!options_.sound && random_.below(8) == 0) {
      text += ",note=" + std::string(200 + random_.below(400), 'a') + "ü ü,<&>%20+1";
    }
    return text;
  }

  void style(std::vector<Segment>& segments) {
    const double height_m = random_.uniform(0.1, 12.0);
    const bool varied = random_.below(3) == 0;
    for (auto& segment : segments) {
      segment.height_m = varied && random_.below(3) == 0 ? random_.uniform(0, 2) : height_m;
      segment.in_out = varied && random_.below(4) == 0 ? InOut::kIndoor : InOut::kOutdoor;
      segment.semantic = varied && random_.below(3) == 0 ? "door" : "wall,brick";
    }
  }

  static std::vector<Segment> chain(const std::vector<Point>& points, bool closed) {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
      segments.push_back({points[i], points[(i + 1) % points.size()], 0.0, InOut::kOutdoor, {}});
    }
    return segments;
  }

  std::vector<Point> star(Point center, double radius_m, bool clockwise) {
    std::vector<Point> points;
    const auto corners = 3 + random_.below(9);
    const double turn = random_.uniform(0, 360);
    for (std::uint64_t i = 0; i < corners; ++i) {
      const double angle = turn + (clockwise ? -1.0 : 1.0) * 360.0 * static_cast<double>(i) /
                                      static_cast<double>(corners);
      points.push_back(center + random_.uniform(0.7, 1.0) * radius_m * unit_vector_deg(angle));
    }
    return points;
  }

  void add_solid() {
    const Point center = somewhere(30.0);
    const auto type = random_.below(4) == 0 ? ShapeType::kClosedCurve : ShapeType::kClosedPolygon;
    auto& outer = add(type, "building");
    outer.segments = chain(star(center, 25.0, false), true);
    style(outer.segments);
    const Obstacle outline = outer;
    if (random_.below(2) != 0) return;
    for (int i = 0; i < 2; ++i) {
      auto& hole = add(type, "court");
      if (random_.below(2) == 0) {
        hole.semantic =
            outline.semantic.with_value(semantic_key::kInnerOf, std::to_string(outline.id));
      }
      hole.segments = chain(star(center + Point{i == 0 ? -3.5 : 3.5, 0.0}, 2.0, true), true);
      style(hole.segments);
    }
  }

  void add_wall() {
    std::vector<Point> points{somewhere(60.0)};
    for (auto i = 1 + random_.below(6); i > 0; --i) {
      points.push_back(points.back() + Point{random_.uniform(1, 9), random_.uniform(-9, 9)});
    }
    auto& wall =
        add(random_.below(4) == 0 ? ShapeType::kOpenCurve : ShapeType::kOpenPolygon, "wall");
    wall.segments = chain(points, random_.below(5) == 0 && points.size() > 2);
    style(wall.segments);
  }

  void add_stairs() {
    auto& stairs = add(ShapeType::kStairs, "step");
    const Point foot = somewhere(20.0);
    const auto count = 2 + random_.below(6);
    for (std::uint64_t i = 0; i < count; ++i) {
      const double y = foot.y + 0.3 * static_cast<double>(i);
      stairs.segments.push_back({{foot.x, y},
                                 {foot.x + 4.0, y},
                                 0.17 * static_cast<double>(i + 1),
                                 InOut::kOutdoor,
                                 "riser"});
    }
    const double top = foot.y + 0.3 * static_cast<double>(count);
    stairs.segments.push_back({{foot.x + 4.0, top}, {foot.x, top}, 0.0, InOut::kOutdoor, "riser"});
  }

  void add_ramp() {
    auto& ramp = add(ShapeType::kRamp, "ramp,normal=0:-0.0995:0.995");
    ramp.segments = chain(star(somewhere(20.0), 5.0, false), true);
  }

  void add_room() {
    auto& room = add(ShapeType::kClosedPolygon, "room");
    room.segments = chain(star(somewhere(30.0), 12.0, true), true);
    style(room.segments);
  }

  void add_something() {
    switch (random_.below(6)) {
      case 0:
        return add_wall();
      case 1:
        return add_stairs();
      case 2:
        return add_ramp();
      case 3:
        return add_room();
      default:
        return add_solid();
    }
  }

  void spoil() {
    if (random_.below(3) == 0) std::swap(map_.border.left, map_.border.right);
    if (random_.below(2) == 0) add(ShapeType::kOpenPolygon, "nothing");
    auto& bow_tie = add(ShapeType::kClosedPolygon, "bow");
    bow_tie.segments = chain({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, true);
    style(bow_tie.segments);
    auto& torn = add(ShapeType::kClosedPolygon, "torn");
    torn.segments = chain(star({50, 50}, 10, false), true);
    torn.segments.front().b.x += 1.0;
    torn.id = map_.obstacles.front().id;
    auto& point = add(ShapeType::kOpenPolygon, "point");
    point.segments = chain({{1, 1}, {1, 1}, {2, 1}}, false);
    if (random_.below(4) == 0) point.id = INT64_MAX - 5;
    if (random_.below(4) == 0) std::swap(map_.obstacles.front(), map_.obstacles.back());
  }

  Random& random_;
  RandomSiteOptions options_;
  Map map_;
  std::int64_t next_id_ = 0;
};

inline Map random_site(Random& random, const RandomSiteOptions& options = {}) {
  return RandomSite(random, options).make();
}

}  // namespace mapwright::test
