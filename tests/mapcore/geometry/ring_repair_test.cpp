#include "mapcore/geometry/ring_repair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/random.hpp"

namespace mapwright {
namespace {

using Ring = std::vector<Point>;

Point to_millimetres(Point p) {
  return {std::round(p.x * 1000.0) / 1000.0, std::round(p.y * 1000.0) / 1000.0};
}

double area_m2(const std::vector<SimplePolygon>& polygons) {
  double area = 0.0;
  for (const auto& polygon : polygons) {
    area += signed_area_m2(polygon.outer);
    for (const auto& hole : polygon.holes) area += signed_area_m2(hole);
  }
  return area;
}

std::vector<SimplePolygon> repaired(const std::vector<Ring>& rings) {
  const auto polygons = odd_even_polygons(rings, to_millimetres);
  EXPECT_TRUE(polygons.has_value());
  return polygons.value_or(std::vector<SimplePolygon>{});
}

TEST(RingRepair, KeepsASimpleRingAndTurnsItCounterClockwise) {
  const auto polygons = repaired({{{0, 0}, {0, 2}, {2, 2}, {2, 0}}});
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].outer, (Ring{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_TRUE(polygons[0].holes.empty());
}

TEST(RingRepair, CutsABowTieAtItsCrossing) {
  const auto polygons = repaired({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  ASSERT_EQ(polygons.size(), 2U);
  EXPECT_EQ(polygons[0].outer, (Ring{{0, 0}, {1, 1}, {0, 2}}));
  EXPECT_EQ(polygons[1].outer, (Ring{{2, 0}, {2, 2}, {1, 1}}));
}

TEST(RingRepair, DropsASpikeAndARetracedEdge) {
  EXPECT_DOUBLE_EQ(area_m2(repaired({{{0, 0}, {2, 0}, {5, 0}, {2, 0}, {2, 2}, {0, 2}}})), 4.0);
  EXPECT_TRUE(repaired({{{0, 0}, {3, 0}, {1, 0}}}).empty());
}

TEST(RingRepair, MakesAHoleOfAnInnerLoop) {
  // The outline touches itself at (1, 2): a square with a triangle cut in from its top edge.
  const auto polygons = repaired({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {3, 2}, {1, 2}, {2, 4}, {0, 4}}});
  ASSERT_EQ(polygons.size(), 1U);
  ASSERT_EQ(polygons[0].holes.size(), 1U);
  EXPECT_EQ(ring_orientation(polygons[0].holes[0]), RingOrientation::kClockwise);
  EXPECT_DOUBLE_EQ(area_m2(polygons), 14.0);
}

TEST(RingRepair, CountsOverlapsByTheOddEvenRule) {
  const Ring left{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  const Ring right{{2, 1}, {5, 1}, {5, 2}, {2, 2}};
  EXPECT_DOUBLE_EQ(area_m2(repaired({left, right})), 9.0 + 3.0 - 2.0);
  EXPECT_TRUE(repaired({left, left}).empty());
}

TEST(RingRepair, GivesSimpleRingsOnTheGridForRandomScribbles) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    Ring ring;
    for (int k = 0; k < 12; ++k) {
      ring.push_back(to_millimetres({random.uniform(0.0, 3.0), random.uniform(0.0, 3.0)}));
    }
    for (const auto& polygon : repaired({ring})) {
      EXPECT_TRUE(is_simple_ring(polygon.outer));
      EXPECT_EQ(ring_orientation(polygon.outer), RingOrientation::kCounterClockwise);
      for (const Point p : polygon.outer) EXPECT_EQ(p, to_millimetres(p));
      for (const auto& hole : polygon.holes) {
        EXPECT_TRUE(is_simple_ring(hole));
        EXPECT_EQ(ring_orientation(hole), RingOrientation::kClockwise);
      }
    }
  }
}

TEST(ChainRepair, LetsAChainTouchItselfButNotCross) {
  EXPECT_TRUE(is_simple_chain(Ring{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}}));
  EXPECT_FALSE(is_simple_chain(Ring{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -1}}));
  EXPECT_FALSE(is_simple_chain(Ring{{0, 0}, {4, 0}, {1, 0}}));
}

TEST(ChainRepair, CutsAtTheCrossingAndKeepsTheDirection) {
  const auto pieces = simple_chains({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -1}}, to_millimetres);
  ASSERT_TRUE(pieces.has_value());
  ASSERT_EQ(pieces->size(), 3U);
  EXPECT_EQ((*pieces)[0], (Ring{{0, 0}, {2, 0}}));
  EXPECT_EQ((*pieces)[1], (Ring{{2, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}}));
  EXPECT_EQ((*pieces)[2], (Ring{{2, 0}, {2, -1}}));
}

TEST(ChainRepair, WalksARetracedPieceOnce) {
  const auto pieces = simple_chains({{0, 0}, {4, 0}, {1, 0}, {1, 3}}, to_millimetres);
  ASSERT_TRUE(pieces.has_value());
  ASSERT_EQ(pieces->size(), 2U);
  EXPECT_EQ((*pieces)[0], (Ring{{0, 0}, {1, 0}, {4, 0}}));
  EXPECT_EQ((*pieces)[1], (Ring{{1, 0}, {1, 3}}));
}

}  // namespace
}  // namespace mapwright
