// The scene and its bins.
#include "navcore/engine/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mapcore/random.hpp"
#include "navcore/engine/iso_line.hpp"
#include "navcore/engine/planar.hpp"
#include "navcore/engine/simple_ring.hpp"
#include "tests/navcore/hand_made_maps.hpp"
#include "tests/support/random_map.hpp"

namespace mapwright::navcore::engine {
namespace {

TEST(ItemBins, FindEverythingThatTouchesABox) {
  Random random(1);
  std::vector<BinItem> items;
  for (int i = 0; i < 500; ++i) {
    const Point a{random.uniform(-50, 50), random.uniform(-20, 20)};
    const double reach = i % 20 == 0 ? 60.0 : 3.0;
    items.push_back(
        BinItem::segment(a, a + Point{random.uniform(-reach, reach),
                                      i % 7 == 0 ? 0.0 : random.uniform(-reach, reach)}));
  }
  const ItemBins bins(items);
  for (int i = 0; i < 200; ++i) {
    const Point center{random.uniform(-60, 60), random.uniform(-30, 30)};
    const Square square{random.uniform(0.1, 5.0)};
    std::vector<bool> found(items.size());
    bins.visit({center.x - square.half_m, center.y - square.half_m, center.x + square.half_m,
                center.y + square.half_m},
               [&](std::uint32_t item) { found[item] = true; });
    for (std::size_t k = 0; k < items.size(); ++k) {
      EXPECT_TRUE(found[k] || !square.meets(items[k].a - center, items[k].b - center)) << k;
    }
  }
}

TEST(ItemBins, TakeWhateverNumbersThereAre) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Scene scene(test::random_map(random));
    EXPECT_LE(scene.bins().columns(), 1'000'002);
  }
}

TEST(Scene, KnowsRingsByTheirSense) {
  const auto points = test::rectangle(1, 1, 3, 3);
  const Scene scene(test::map10({test::ring(1, points), test::ring(2, test::reversed(points)),
                                 test::wall(3, points), test::stairs(4, 0, 1, 0, 3)}));
  ASSERT_EQ(scene.obstacles().size(), 4U);
  EXPECT_TRUE(scene.obstacles()[0].simple_ring && scene.obstacles()[0].counter_clockwise);
  EXPECT_TRUE(scene.obstacles()[1].simple_ring && !scene.obstacles()[1].counter_clockwise);
  EXPECT_FALSE(scene.obstacles()[2].simple_ring);
  EXPECT_TRUE(scene.obstacles()[3].stairs);
}

TEST(RingShape, IsUnclearForWhatCrossesOrTouchesItself) {
  EXPECT_EQ(ring_shape(test::rectangle(0, 0, 1, 1)), RingShape::kCounterClockwise);
  EXPECT_EQ(ring_shape(std::vector<Point>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}), RingShape::kUnclear);
  EXPECT_EQ(ring_shape(std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {2, 0}}), RingShape::kUnclear);
  EXPECT_EQ(ring_shape(std::vector<Point>{{0, 0}, {4, 0}, {2, 0}, {2, 3}}), RingShape::kUnclear);
  EXPECT_EQ(ring_shape(std::vector<Point>{{0, 0}, {1, 0}}), RingShape::kUnclear);
}

TEST(IsoLine, HasTheLowSideOnItsLeft) {
  const Scene scene(test::map10({test::ramp(1, 2, 2, 10, 8)}));
  ASSERT_EQ(scene.ramps().size(), 1U);
  const auto lines = iso_lines(scene.ramps()[0], 0.4);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_GT(side_of_line(lines[0].a, lines[0].b, {2, 5}), 0.0);
  EXPECT_NEAR(lines[0].a.x, 2.0 + 0.4 * 0.9968 / 0.08, 1e-9);
  EXPECT_NEAR(distance(lines[0].a, lines[0].b), 6.0, 1e-9);
}

// At height 0 the contour is the foot itself, which belongs to the footprint.
TEST(IsoLine, TheFootprintIsClosed) {
  const Scene scene(test::map10({test::ramp(1, 2, 2, 10, 8)}));
  const auto lines = iso_lines(scene.ramps()[0], 0.0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].a.x, 2.0, 1e-9);
}

}  // namespace
}  // namespace mapwright::navcore::engine
