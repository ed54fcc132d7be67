// docs/decisions/0011-overlapping-obstacles.md: cases, and GEOS as a judge of random ones.
#include <geos_c.h>
#include <gtest/gtest.h>

#include "mapcore/geometry/orientation.hpp"
#include "tests/mapcore/geometry/generators.hpp"
#include "tests/validators/shapes.hpp"

namespace mapwright::test {
namespace {

const Obstacle kBuilding = solid(1, {0, 0, 20, 20});
const Obstacle kYard = hollow(2, {5, 5, 15, 15}, "yard,inner_of=1");
const Obstacle kRoom = hollow(1, {0, 0, 20, 20});

TEST(Overlap, OfNeighboursIsNone) {
  EXPECT_EQ(found_in({kBuilding, solid(2, {20, 0, 30, 20})}), "");
  EXPECT_EQ(found_in({kBuilding, solid(2, {20, 5, 30, 10})}), "");
  EXPECT_EQ(found_in({kBuilding, solid(2, {20, 20, 30, 30})}), "");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{20, 5}, {30, 5}})}), "");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{5, 0}, {8, 0}, {8, -5}})}), "");
}

TEST(Overlap, ShallowerThanRoundingIsTouching) {
  EXPECT_EQ(found_in({kBuilding, solid(2, {19.999, 0.001, 30, 19.998})}), "");
  EXPECT_EQ(found_in({kBuilding, solid(2, {19.99, 5, 30, 10})}), "G108:2.1 ");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{19.999, 5}, {30, 5}})}), "");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{19.99, 5}, {30, 5}})}), "G108:2.1 ");
}

TEST(Overlap, BlamesTheLaterObstacleWhereItBegins) {
  EXPECT_EQ(found_in({kBuilding, solid(2, {15, -5, 30, 10})}), "G108:2.3 ");
  EXPECT_EQ(found_in({solid(1, {15, -5, 30, 10}), solid(2, {0, 0, 20, 20})}), "G108:2.1 ");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{-5, 5}, {-1, 5}, {25, 6}})}), "G108:2.2 ");
  EXPECT_EQ(found_in({wall(1, {{-5, 5}, {25, 6}}), solid(2, {0, 0, 20, 20})}), "G108:2.4 ");
}

TEST(Overlap, OfWhatLiesInsideASolid) {
  EXPECT_EQ(found_in({kBuilding, solid(2, {5, 5, 6, 6})}), "G124:2 ");
  EXPECT_EQ(found_in({solid(1, {5, 5, 6, 6}), solid(2, {0, 0, 20, 20})}), "G124:1 ");
  EXPECT_EQ(found_in({kBuilding, wall(2, {{5, 5}, {6, 6}})}), "G124:2 ");
  EXPECT_EQ(found_in({kBuilding, solid(2, {5, 5, 9, 9}), solid(3, {6, 6, 7, 7})}),
            "G124:2 G124:3 ");
  EXPECT_EQ(found_in({kBuilding, solid(2, {0, 5, 6, 6})}), "G108:2.1 ");
}

TEST(Overlap, OfTheSameBuildingTwice) {
  EXPECT_EQ(found_in({kBuilding, solid(2, {0, 0, 20, 20})}), "G108:2 ");
  EXPECT_EQ(found_in({kBuilding, solid(2, {0.001, 0, 20, 20.001})}), "G108:2 ");
  EXPECT_EQ(found_in({kBuilding, solid(2, {0, 0, 20, 10})}), "G108:2.3 ");
}

TEST(Overlap, DoesNotCountInACourtyard) {
  EXPECT_EQ(found_in({kBuilding, kYard, solid(3, {6, 6, 8, 8})}), "");
  EXPECT_EQ(found_in({kBuilding, kYard, solid(3, {5, 5, 15, 15})}), "");
  EXPECT_EQ(found_in({kBuilding, kYard, wall(3, {{5, 10}, {15, 10}})}), "");
  EXPECT_EQ(found_in({kBuilding, kYard, solid(3, {4, 6, 8, 8})}), "G108:3.1 ");
  EXPECT_EQ(found_in({kBuilding, kYard, wall(3, {{10, 10}, {17, 10}})}), "G108:3.1 ");
  EXPECT_EQ(found_in({kBuilding, kYard, wall(3, {{10, 10}, {27, 10}})}), "G108:3.1 ");
}

TEST(Overlap, OfCourtyardsWithTheirBuildingAndEachOther) {
  EXPECT_EQ(found_in({kBuilding, hollow(2, {15, 5, 20.5, 15}, "yard")}), "G107:2 G108:2.3 ");
  EXPECT_EQ(found_in({kBuilding, kYard, hollow(3, {10, 10, 18, 18}, "yard,inner_of=1")}),
            "G108:3.3 ");
}

TEST(Overlap, DoesNotCountInARoomButAcrossItsWall) {
  EXPECT_EQ(found_in({kRoom, solid(2, {5, 5, 6, 6})}), "");
  EXPECT_EQ(found_in({kRoom, solid(2, {0, 0, 5, 5})}), "");
  EXPECT_EQ(found_in({kRoom, solid(2, {5, 5, 6, 6}), solid(3, {18, 5, 25, 6})}), "G108:3.1 ");
  EXPECT_EQ(found_in({kRoom, solid(2, {5, 5, 6, 6}), wall(3, {{20, 5}, {25, 6}})}), "");
  EXPECT_EQ(found_in({kRoom, solid(2, {5, 5, 6, 6}), wall(3, {{10, 10}, {20, 10}, {25, 10}})}),
            "G108:3.2 ");
}

TEST(Overlap, IgnoresRampsAndHeightZero) {
  const Points footprint{{5, 5}, {9, 5}, {9, 9}, {5, 9}, {5, 5}};
  EXPECT_EQ(
      found_in({kBuilding, chain(2, ShapeType::kRamp, footprint, 0.0, "normal=-0.0995:0:0.995")}),
      "");
  EXPECT_EQ(found_in({kBuilding, chain(2, ShapeType::kClosedPolygon, footprint, 0.0)}),
            "S122:2.1 ");
}

class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {}
  Geos(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(context_); }

  double common_area_m2(const Points& p, const Points& q) const {
    auto* first = polygon(p);
    auto* second = polygon(q);
    auto* common = GEOSIntersection_r(context_, first, second);
    double area = -1.0;
    GEOSArea_r(context_, common, &area);
    for (auto* geometry : {first, second, common}) GEOSGeom_destroy_r(context_, geometry);
    return area;
  }

 private:
  GEOSGeometry* polygon(const Points& points) const {
    const auto size = static_cast<unsigned>(points.size() + 1);
    auto* sequence = GEOSCoordSeq_create_r(context_, size, 2);
    for (unsigned i = 0; i < size; ++i) {
      const Point p = points[i % points.size()];
      GEOSCoordSeq_setXY_r(context_, sequence, i, p.x, p.y);
    }
    auto* shell = GEOSGeom_createLinearRing_r(context_, sequence);
    return GEOSGeom_createPolygon_r(context_, shell, nullptr, 0);
  }

  GEOSContextHandle_t context_;
};

// Simple rings with corners on a grid of metres: they share corners and edges more often than not.
Points random_solid(Random& random) {
  while (true) {
    Points points(3 + random.below(6));
    for (auto& p : points) {
      p = {static_cast<double>(random.below(7)), static_cast<double>(random.below(7))};
    }
    if (!is_simple_ring(points)) continue;
    const bool is_solid = ring_orientation(points) == RingOrientation::kCounterClockwise;
    return is_solid ? points : reversed(points);
  }
}

TEST(Overlap, IsFoundWhereGeosSeesCommonArea) {
  const Geos geos;
  Random random(21);
  int overlaps = 0;
  constexpr int kPairs = 20'000;
  for (int i = 0; i < kPairs; ++i) {
    const Points p = random_solid(random), q = random_solid(random);
    const bool expected = geos.common_area_m2(p, q) > 1e-9;
    overlaps += expected ? 1 : 0;
    const std::string found = found_in({ring(1, p), ring(2, q)});
    const bool told = found.find("G108:2") != found.npos || found.find("G124:") != found.npos;
    ASSERT_EQ(told, expected) << i << " " << found;
  }
  EXPECT_GT(overlaps, kPairs / 4);
  EXPECT_LT(overlaps, kPairs * 9 / 10);
}

}  // namespace
}  // namespace mapwright::test
