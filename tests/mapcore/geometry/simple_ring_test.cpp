#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"
#include "tests/mapcore/geometry/generators.hpp"

namespace mapwright {
namespace {

// The definition, edge pair by edge pair.
bool is_simple_by_pairs(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (ring[i] == ring[(i + 1) % n]) return false;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (ring[i] == ring[j]) return false;
      const auto meeting = meet(ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]);
      const bool neighbours = j == i + 1 || (i == 0 && j + 1 == n);
      if (meeting.kind == Meeting::kNone) continue;
      if (!neighbours || meeting.kind != Meeting::kTouch) return false;
    }
  }
  return true;
}

class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {}
  Geos(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(context_); }

  bool is_simple_ring(const std::vector<Point>& ring) const {
    auto* line = GEOSGeom_createLinearRing_r(context_, coordinates(ring));
    const bool simple = GEOSisSimple_r(context_, line) == 1;
    GEOSGeom_destroy_r(context_, line);
    return simple;
  }

  bool is_valid_polygon(const std::vector<Point>& ring) const {
    auto* shell = GEOSGeom_createLinearRing_r(context_, coordinates(ring));
    auto* polygon = GEOSGeom_createPolygon_r(context_, shell, nullptr, 0);
    const bool valid = GEOSisValid_r(context_, polygon) == 1;
    GEOSGeom_destroy_r(context_, polygon);
    return valid;
  }

 private:
  GEOSCoordSequence* coordinates(const std::vector<Point>& ring) const {
    const auto size = static_cast<unsigned>(ring.size() + 1);
    auto* sequence = GEOSCoordSeq_create_r(context_, size, 2);
    for (unsigned i = 0; i < size; ++i) {
      const Point p = ring[i % ring.size()];
      GEOSCoordSeq_setXY_r(context_, sequence, i, p.x, p.y);
    }
    return sequence;
  }

  GEOSContextHandle_t context_;
};

// Rings in which one vertex is put where it does harm: on another, on an edge, beside an edge.
void damage(std::vector<Point>& ring, Random& random) {
  const std::size_t n = ring.size();
  const std::size_t i = random.below(n), j = random.below(n);
  switch (random.below(5)) {
    case 0:
      ring[i] = ring[j];
      break;
    case 1:
      ring[i] = 0.5 * ring[j] + 0.5 * ring[(j + 1) % n];
      break;
    case 2:
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i), ring[j]);
      break;
    case 3:
      std::swap(ring[i], ring[j]);
      break;
    default:
      break;
  }
}

std::vector<Point> random_ring(Random& random, std::size_t most,
                               test::Nudges nudges = test::Nudges::kYes) {
  const std::size_t count = 3 + random.below(most - 2);
  auto ring = random.below(2) == 0 ? test::random_points(random, count, nudges)
                                   : test::star_ring(random, count);
  if (random.below(3) == 0) damage(ring, random);
  return ring;
}

// Several coordinates that are not equal and differ by rounding only.
bool has_vertices_a_few_ulps_apart(const std::vector<Point>& ring) {
  const auto close = [](double u, double v) { return u != v && std::abs(u - v) < 1e-14; };
  for (const Point p : ring) {
    for (const Point q : ring) {
      if (close(p.x, q.x) || close(p.y, q.y)) return true;
    }
  }
  return false;
}

bool has_zero_length_edge(const std::vector<Point>& ring) {
  return std::adjacent_find(ring.begin(), ring.end()) != ring.end() || ring.front() == ring.back();
}

TEST(SimpleRing, KnowsTheDegenerateOnes) {
  using Ring = std::vector<Point>;
  EXPECT_TRUE(is_simple_ring(Ring{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(is_simple_ring(Ring{{0, 0}, {1, 0}, {2, 0}, {0, 1}}));           // straight vertex
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {1, 0}}));                          // two vertices
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {1, 0}, {2, 0}}));                  // no area
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {0, 0}, {1, 0}, {0, 1}}));          // repeated vertex
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {2, 2}, {2, 0}, {0, 2}}));          // bow tie
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {3, 0}, {2, 0}, {2, 2}}));          // spike
  EXPECT_FALSE(is_simple_ring(Ring{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));  // touches an edge
  EXPECT_FALSE(
      is_simple_ring(Ring{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}));  // touches a vertex
}

TEST(SimpleRing, EqualsTheDefinitionOnRandomRings) {
  Random random(6);
  int simple = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto ring = random_ring(random, 12);
    const bool expected = is_simple_by_pairs(ring);
    simple += expected ? 1 : 0;
    ASSERT_EQ(is_simple_ring(ring), expected) << i;
  }
  EXPECT_GT(simple, 20'000);
  EXPECT_LT(simple, 80'000);
}

TEST(SimpleRing, EqualsTheDefinitionWhereTheSweepDecides) {
  Random random(7);
  int simple = 0;
  for (int i = 0; i < 4'000; ++i) {
    auto ring = test::star_ring(random, 25 + random.below(50));
    if (i % 8 != 0) {
      for (auto& p : ring) p = {std::round(p.x * 4.0) / 4.0, std::round(p.y * 4.0) / 4.0};
    }
    if (random.below(2) == 0) damage(ring, random);
    const bool expected = is_simple_by_pairs(ring);
    simple += expected ? 1 : 0;
    ASSERT_EQ(is_simple_ring(ring), expected) << i;
  }
  EXPECT_GT(simple, 400);
  EXPECT_LT(simple, 3'600);
}

// GEOS passes over zero-length edges; those rings are left out. Polygon validity means the same as
// simplicity for a ring without hole: GEOS refuses a ring that touches itself as well.
TEST(SimpleRing, AgreesWithGeosOnRandomRings) {
  const Geos geos;
  Random random(8);
  int compared = 0;
  for (int i = 0; i < 150'000; ++i) {
    const auto ring = random_ring(random, 12, test::Nudges::kNo);
    if (has_zero_length_edge(ring)) continue;
    ++compared;
    const bool simple = is_simple_ring(ring);
    ASSERT_EQ(geos.is_simple_ring(ring), simple) << i;
    ASSERT_EQ(geos.is_valid_polygon(ring), simple) << i;
  }
  EXPECT_GT(compared, 100'000);
}

// GEOS computes crossing points in rounded arithmetic, so where vertices lie a few units in the
// last place beside each other it takes a neighbours' joint for a crossing or the reverse. There
// the exact definition decides.
TEST(SimpleRing, DisagreesWithGeosOnlyWhereGeosRounds) {
  const Geos geos;
  Random random(9);
  for (int i = 0; i < 50'000; ++i) {
    const auto ring = random_ring(random, 12, test::Nudges::kYes);
    if (has_zero_length_edge(ring)) continue;
    const bool simple = is_simple_ring(ring);
    if (geos.is_simple_ring(ring) == simple && geos.is_valid_polygon(ring) == simple) continue;
    ASSERT_EQ(simple, is_simple_by_pairs(ring)) << i;
    ASSERT_TRUE(has_vertices_a_few_ulps_apart(ring)) << i;
  }
}

// Every turn of a pentagram is to the left, and it goes around twice.
TEST(SimpleRing, KnowsAPentagramFromAPentagon) {
  const std::vector<Point> pentagon{{0, -10}, {9.5, -3.1}, {5.9, 8.1}, {-5.9, 8.1}, {-9.5, -3.1}};
  EXPECT_TRUE(is_simple_ring(pentagon));
  std::vector<Point> pentagram;
  for (std::size_t i = 0; i < 5; ++i) pentagram.push_back(pentagon[2 * i % 5]);
  EXPECT_FALSE(is_simple_ring(pentagram));
  EXPECT_FALSE(is_simple_ring(std::vector<Point>(pentagram.rbegin(), pentagram.rend())));
  std::vector<Point> twice = pentagon;
  twice.insert(twice.end(), pentagon.begin(), pentagon.end());
  EXPECT_FALSE(is_simple_ring(twice));
}

// Axis-parallel edges have no direction to the left or right; small grids have every degeneracy.
TEST(SimpleRing, AgreesWithPairsOnSmallGrids) {
  Random random(12);
  int simple = 0;
  for (int round = 0; round < 40000; ++round) {
    std::vector<Point> ring(3 + random.below(4));
    for (Point& p : ring) {
      p = {static_cast<double>(random.below(4)), static_cast<double>(random.below(4))};
    }
    ASSERT_EQ(is_simple_ring(ring), is_simple_by_pairs(ring)) << round;
    simple += is_simple_ring(ring) ? 1 : 0;
  }
  EXPECT_GT(simple, 4000);
}

}  // namespace
}  // namespace mapwright
