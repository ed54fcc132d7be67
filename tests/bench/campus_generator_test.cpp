#include "bench/support/campus_generator.hpp"

#include <gtest/gtest.h>

#include <map>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/text/writer.hpp"

namespace mapwright {
namespace {

using bench::generate_campus;

TEST(CampusGenerator, HasTheSizeAskedFor) {
  EXPECT_EQ(segment_count(generate_campus(bench::kCampus100m)), 520U);
  EXPECT_EQ(segment_count(generate_campus(bench::kCampus1km)), 52'000U);
  EXPECT_EQ(segment_count(generate_campus({30.0, 1, 7})), 1U);
  EXPECT_EQ(segment_count(generate_campus({25.0, 5000, 7})), 5000U);
}

TEST(CampusGenerator, IsTheSameForTheSameSeed) {
  EXPECT_EQ(generate_campus({200.0, 3000, 5}), generate_campus({200.0, 3000, 5}));
  EXPECT_FALSE(generate_campus({200.0, 3000, 5}) == generate_campus({200.0, 3000, 6}));
}

TEST(CampusGenerator, LiesOnTheMillimetreGridWithinTheBorder) {
  const Map map = generate_campus(bench::kCampus1km);
  EXPECT_EQ(quantized(map), map);
  const Box box = extent(map);
  EXPECT_TRUE(map.border.contains({box.min_x, box.min_y}));
  EXPECT_TRUE(map.border.contains({box.max_x, box.max_y}));
}

TEST(CampusGenerator, ClosedShapesAreSimpleAndCounterClockwise) {
  std::map<ShapeType, int> kinds;
  for (const auto& obstacle : generate_campus(bench::kCampus1km).obstacles) {
    ++kinds[obstacle.shape_type];
    if (!is_closed(obstacle.shape_type)) continue;
    const auto ring = chain_points(obstacle);
    ASSERT_EQ(ring.size(), obstacle.segments.size()) << "obstacle " << obstacle.id;
    ASSERT_TRUE(is_simple_ring(ring)) << "obstacle " << obstacle.id;
    ASSERT_EQ(ring_orientation(ring), RingOrientation::kCounterClockwise) << obstacle.id;
  }
  for (const auto kind :
       {ShapeType::kClosedPolygon, ShapeType::kOpenPolygon, ShapeType::kStairs, ShapeType::kRamp}) {
    EXPECT_GT(kinds[kind], 50) << static_cast<int>(kind);
  }
}

TEST(CampusGenerator, ObstaclesKeepApart) {
  const Map map = generate_campus({200.0, 2080, 3});
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const auto& s : map.obstacles[i].segments) {
        for (const auto& t : map.obstacles[j].segments) {
          ASSERT_EQ(meet(s.a, s.b, t.a, t.b).kind, Meeting::kNone)
              << "obstacles " << map.obstacles[i].id << " and " << map.obstacles[j].id;
        }
      }
    }
  }
}

}  // namespace
}  // namespace mapwright
