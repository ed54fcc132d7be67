// Parts of maps: whole obstacles, and cut ones.
#include "mapcore/parts/crop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/reader.hpp"
#include "mapcore/text/writer.hpp"
#include "tests/support/random_site.hpp"

namespace mapwright {
namespace {

std::string segment(const std::string& ends, const std::string& height = "3") {
  return ends + ";" + height + ";1;brick;#";
}

// A solid from (0, 0) to (10, 10) with a court from (4, 4) to (6, 6), and a wall along y = 20.
Map yard() {
  const MapDocument document = read_map(
      "border;-5;30;30;-5;#"
      "obstacle;3;1;4;house;#" +
      segment("0;0;10;0") + segment("10;0;10;10") + segment("10;10;0;10") + segment("0;10;0;0") +
      "obstacle;4;1;4;house,inner_of=3;#" + segment("4;4;4;6") + segment("4;6;6;6") +
      segment("6;6;6;4") + segment("6;4;4;4") + "obstacle;7;2;2;wall;#" +
      segment("0;20;10;20", "2") + segment("10;20;20;20", "1"));
  EXPECT_TRUE(document.findings.empty());
  return document.map;
}

std::vector<std::int64_t> ids(const Map& map) {
  std::vector<std::int64_t> all;
  for (const auto& obstacle : map.obstacles) all.push_back(obstacle.id);
  return all;
}

Crop cropped(const Map& map, const Box& box, bool cut = false) {
  auto part = crop(map, {box, std::nullopt, 0.0}, {cut, 0.001});
  EXPECT_TRUE(part.has_value());
  return *std::move(part);
}

TEST(Crop, KeepsWhatTouchesAndCourtyardsWithTheirOutline) {
  const Map map = yard();
  EXPECT_EQ(ids(cropped(map, {10, 5, 12, 6}).map), (std::vector<std::int64_t>{3, 4}));
  EXPECT_EQ(ids(cropped(map, {11, 5, 12, 6}).map), std::vector<std::int64_t>{});
  EXPECT_EQ(ids(cropped(map, {20, 19, 22, 22}).map), std::vector<std::int64_t>{7});
  const auto part = cropped(map, {8, 5, 12, 40});
  EXPECT_EQ(part.map.obstacles, map.obstacles);
  EXPECT_EQ(part.map.border, (Border{8, 30, 12, 5}));
  EXPECT_EQ(part.protruding, 3U);
  EXPECT_EQ(part.dropped, 0U);
}

TEST(Crop, SolidAroundThePartCountsAndItsCourtyardDoesNot) {
  const Map map = yard();
  EXPECT_EQ(ids(cropped(map, {1, 1, 3, 3}).map), (std::vector<std::int64_t>{3, 4}));
  EXPECT_EQ(ids(cropped(map, {4.5, 4.5, 5.5, 5.5}).map), std::vector<std::int64_t>{});
}

TEST(Crop, DiscTakesWhatComesAsNearAsItsRadius) {
  const Map map = yard();
  const auto near = crop(map, CropRegion::of_disc({15, 5}, 5.0));
  ASSERT_TRUE(near);
  EXPECT_EQ(ids(near->map), (std::vector<std::int64_t>{3, 4}));
  EXPECT_EQ(near->map.border, (Border{10, 10, 20, 0}));
  EXPECT_TRUE(crop(map, CropRegion::of_disc({15, 5}, 4.99))->map.obstacles.empty());
  // The corner of the disc's box is not the disc.
  EXPECT_TRUE(crop(map, CropRegion::of_disc({14, 14}, 5.5))->map.obstacles.empty());
}

TEST(Crop, RefusesWhatTheBorderDoesNotHold) {
  EXPECT_FALSE(crop(yard(), {{100, 100, 110, 110}, std::nullopt, 0.0}));
  EXPECT_FALSE(crop(yard(), CropRegion::of_disc({5, 5}, 1.0), {true, 0.001}));
}

TEST(Crop, CutSolidsCloseAtTheEdgeAndKeepTheirValues) {
  const auto part = cropped(yard(), {5, 2, 12, 20}, true);
  ASSERT_EQ(ids(part.map), (std::vector<std::int64_t>{3, 7}));
  const auto& house = part.map.obstacles[0];
  const auto ring = chain_points(house);
  EXPECT_EQ(ring_orientation(ring), RingOrientation::kCounterClockwise);
  EXPECT_DOUBLE_EQ(signed_area_m2(ring), 5.0 * 8.0 - 2.0);
  for (const auto& s : house.segments) {
    const bool on_edge = (s.a.x == 5.0 && s.b.x == 5.0) || (s.a.y == 2.0 && s.b.y == 2.0);
    EXPECT_EQ(s.semantic, Semantic(on_edge ? "cut" : "brick"));
    EXPECT_EQ(s.height_m, 3.0);
  }
  const auto& wall = part.map.obstacles[1];
  EXPECT_EQ(wall.segments.front().a, (Point{5, 20}));
  EXPECT_EQ(wall.segments.back().b, (Point{12, 20}));
  EXPECT_EQ(wall.segments.back().height_m, 1.0);
  EXPECT_EQ(part.protruding, 0U);
}

TEST(Crop, PiecesBeyondTheFirstSayWhatTheyArePartOf) {
  const auto part = cropped(yard(), {-1, 4.5, 30, 5.5}, true);
  ASSERT_EQ(ids(part.map), (std::vector<std::int64_t>{3, 8}));
  EXPECT_EQ(part.map.obstacles[1].semantic.value("part_of"), "3");
}

TEST(Crop, PartsOfPartsAreParts) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    test::RandomSiteOptions options;
    options.sound = true;
    const Map map = test::random_site(random, options);
    const auto edge = [&](double from, double to) { return std::round(random.uniform(from, to)); };
    const Box outer{edge(-190, -60), edge(-190, -60), edge(60, 190), edge(60, 190)};
    const Box inner{edge(-250, -20), edge(-50, -20), edge(20, 50), edge(20, 250)};
    const Box both{std::max(outer.min_x, inner.min_x), inner.min_y, inner.max_x,
                   std::min(outer.max_y, inner.max_y)};
    const Map part = read_map(format_map(cropped(map, outer, true).map)).map;
    EXPECT_EQ(format_map(cropped(part, inner, true).map), format_map(cropped(map, both, true).map))
        << seed;
    EXPECT_EQ(format_map(cropped(part, inner).map), format_map(cropped(map, both).map)) << seed;
    EXPECT_EQ(format_map(cropped(part, outer, true).map), format_map(part)) << seed;
  }
}

double solid_area_m2(const Map& map) {
  double area = 0.0;
  for (const auto& o : map.obstacles) {
    const bool is_ring =
        o.shape_type == ShapeType::kClosedPolygon || o.shape_type == ShapeType::kClosedCurve;
    const bool is_room = o.semantic.has_label("room");
    if (is_ring && !is_room) area += signed_area_m2(chain_points(o));
  }
  return area;
}

double wall_length_m(const Map& map) {
  double total = 0.0;
  for (const auto& o : map.obstacles) {
    if (!o.semantic.has_label("wall") && !o.semantic.has_label("room")) continue;
    for (const auto& s : o.segments) total += distance(s.a, s.b);
  }
  return total;
}

// Courts that inner_of does not tie to their outline are rooms to the cutter.
Map with_tied_courts(Map map) {
  for (auto& obstacle : map.obstacles) {
    const bool is_untied = obstacle.semantic.has_label("court");
    if (is_untied) obstacle.semantic = "room";
  }
  return map;
}

TEST(Crop, CutTilesHoldAllOfTheMap) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    test::RandomSiteOptions options;
    options.sound = true;
    const Map map = with_tied_courts(test::random_site(random, options));
    double area = 0.0, length_m = 0.0;
    const double x = std::round(random.uniform(-100, 100));
    const double y = std::round(random.uniform(-100, 100));
    const Box all = map.border.box();
    for (const Box& tile : {Box{all.min_x, all.min_y, x, y}, Box{x, all.min_y, all.max_x, y},
                            Box{all.min_x, y, x, all.max_y}, Box{x, y, all.max_x, all.max_y}}) {
      const auto part = cropped(map, tile, true);
      area += solid_area_m2(part.map);
      length_m += wall_length_m(part.map);
      for (const auto& obstacle : part.map.obstacles) {
        if (obstacle.shape_type == ShapeType::kStairs || obstacle.shape_type == ShapeType::kRamp)
          continue;
        for (const auto& s : obstacle.segments) {
          EXPECT_TRUE(tile.contains(s.a) && tile.contains(s.b)) << seed << " " << obstacle.id;
        }
      }
    }
    EXPECT_NEAR(area, solid_area_m2(map), 0.5) << seed;
    EXPECT_NEAR(length_m, wall_length_m(map), 0.05) << seed;
  }
}

}  // namespace
}  // namespace mapwright
