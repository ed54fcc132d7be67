// Hausdorff distances, and unions of polygons.
#include "mapcore/geometry/hausdorff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/ring_union.hpp"
#include "mapcore/random.hpp"

namespace mapwright {
namespace {

using Points = std::vector<Point>;

TEST(Hausdorff, IsWhatGeometrySays) {
  const Points straight{{0, 0}, {10, 0}};
  EXPECT_NEAR(hausdorff_distance_m(edges_of(straight, false), edges_of(straight, false), 1e-6), 0.0,
              1e-6);
  // A tip 3 away from the middle of a line, in either order.
  const Points tip{{0, 0}, {5, 3}, {10, 0}};
  EXPECT_NEAR(hausdorff_distance_m(edges_of(straight, false), edges_of(tip, false), 1e-6), 3.0,
              1e-5);
  EXPECT_NEAR(hausdorff_distance_m(edges_of(tip, false), edges_of(straight, false), 1e-6), 3.0,
              1e-5);
  // Farthest between the vertices: the middle of the lower side from the other three.
  const Points open{{0, 0}, {0, 2}, {8, 2}, {8, 0}};
  EXPECT_NEAR(hausdorff_distance_m(edges_of(open, true), edges_of(open, false), 1e-6), 2.0, 1e-5);
  EXPECT_EQ(hausdorff_distance_m(edges_of(open, true), {}, 1e-6),
            std::numeric_limits<double>::infinity());
}

double sampled(const std::vector<DrawnEdge>& from, const std::vector<DrawnEdge>& to) {
  double most = 0.0;
  for (const auto& e : from) {
    for (int i = 0; i <= 200; ++i) {
      const Point p = (1.0 - i / 200.0) * e.a + (i / 200.0) * e.b;
      double least = HUGE_VAL;
      for (const auto& f : to)
        least = std::min(least, distance(p, closest_point_on_segment(p, f.a, f.b)));
      most = std::max(most, least);
    }
  }
  return most;
}

TEST(Hausdorff, IsNeverLessThanSampledAndHardlyMore) {
  Random random(11);
  for (int round = 0; round < 100; ++round) {
    Points p, q;
    for (int i = 0; i < 6; ++i) {
      p.push_back({random.uniform(0, 10), random.uniform(0, 10)});
      q.push_back({random.uniform(0, 10), random.uniform(0, 10)});
    }
    const auto a = edges_of(p, true), b = edges_of(q, false);
    const double seen = std::max(sampled(a, b), sampled(b, a));
    const double found = hausdorff_distance_m(a, b, 1e-3);
    EXPECT_GE(found, seen - 1e-12);
    EXPECT_LE(found, seen + 0.08);  // half a sampling step and the slack
  }
}

TEST(RingUnion, MakesOneOutlineOfHousesInARow) {
  std::vector<SimplePolygon> row;
  for (int i = 0; i < 10; ++i) {
    const double x = 5.0 * i;
    row.push_back({{{x, 0}, {x + 5, 0}, {x + 5, 8}, {x, 8}}, {}});
  }
  const auto united = united_polygons(row, [](Point p) { return p; });
  ASSERT_TRUE(united);
  ASSERT_EQ(united->size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area_m2(united->front().outer), 400.0);
  EXPECT_TRUE(united->front().holes.empty());
  EXPECT_EQ(united->front().outer.size(), 4u);
}

TEST(RingUnion, KeepsTheYardThatABlockEncloses) {
  const std::vector<SimplePolygon> block{{{{0, 0}, {10, 0}, {10, 2}, {0, 2}}, {}},
                                         {{{8, 0}, {10, 0}, {10, 10}, {8, 10}}, {}},
                                         {{{0, 8}, {10, 8}, {10, 10}, {0, 10}}, {}},
                                         {{{0, 0}, {2, 0}, {2, 10}, {0, 10}}, {}}};
  const auto united = united_polygons(block, [](Point p) { return p; });
  ASSERT_TRUE(united);
  ASSERT_EQ(united->size(), 1u);
  ASSERT_EQ(united->front().holes.size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area_m2(united->front().holes.front()), -36.0);
}

}  // namespace
}  // namespace mapwright
