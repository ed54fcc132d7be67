// Local polynomials against the transformation they stand for.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "converter/frame/transform_patches.hpp"
#include "converter/pipeline/map_transform.hpp"
#include "mapcore/random.hpp"

namespace mapwright::converter {
namespace {

struct Place {
  const char* crs;
  double x, y;   // in the CRS
  double reach;  // in its units: 10 km to either side
  double latitude_deg, longitude_deg;
};

// Metres, feet, degrees; transverse Mercator, Lambert, oblique stereographic, Web Mercator.
const Place kPlaces[] = {
    {"EPSG:25831", 425800, 4582230, 10000, 41.388, 2.1125},
    {"EPSG:28992", 92500, 437500, 10000, 51.92, 4.48},
    {"EPSG:2154", 652000, 6862000, 10000, 48.85, 2.35},
    {"EPSG:2263", 985000, 200000, 32800, 40.72, -74.0},
    {"EPSG:3857", 235200, 5070000, 13000, 41.388, 2.1125},
    {"EPSG:4326", 2.1125, 41.388, 0.1, 41.388, 2.1125},
    {"EPSG:4258", 23.7, 68.0, 0.1, 68.0, 23.7},
};

class Patches : public testing::TestWithParam<Place> {};

TEST_P(Patches, StayWithinTheirBoundOfProj) {
  const Place& place = GetParam();
  const auto crs = parse_crs(place.crs);
  ASSERT_TRUE(crs);
  Georeference g;
  g.origin_latitude_deg = place.latitude_deg;
  g.origin_longitude_deg = place.longitude_deg;
  g.heading_deg = 17.0;
  const LocalFrame frame(g);
  auto to_wgs84 = CrsTransform::create(*crs);
  ASSERT_TRUE(to_wgs84);
  MapTransform transform(*std::move(to_wgs84), frame, *crs);

  Random random(3);
  std::vector<double> xs, ys;
  for (int i = 0; i < 20000; ++i) {
    xs.push_back(place.x + random.uniform(-place.reach, place.reach));
    ys.push_back(place.y + random.uniform(-place.reach, place.reach));
  }
  auto exact_xs = xs, exact_ys = ys;
  transform.apply_exactly(exact_xs, exact_ys);
  transform.apply(xs, ys);
  double worst = 0.0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    ASSERT_TRUE(std::isfinite(exact_xs[i]));
    worst = std::max(worst, std::hypot(xs[i] - exact_xs[i], ys[i] - exact_ys[i]));
  }
  EXPECT_LE(worst, TransformPatches::kBound_m) << place.crs;
  EXPECT_GT(worst, 0.0) << "no polynomial was used: nothing is compared";
}

INSTANTIATE_TEST_SUITE_P(Crs, Patches, testing::ValuesIn(kPlaces), [](const auto& tested) {
  return std::string(tested.param.crs).replace(4, 1, "_");
});

void bend(std::span<double> xs, std::span<double> ys) {
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double x = xs[i];
    xs[i] = 2.0 * x + std::abs(x - 150.0);  // a kink at 150
    ys[i] = x + 3.0 * ys[i];
  }
}

TEST(TransformPatches, RefusesACellWithAKinkAndIsExactThere) {
  TransformPatches patches(bend, 100.0);
  std::vector<double> xs{50.0, 120.0, 180.0, 250.0}, ys{5.0, 6.0, 7.0, 8.0};
  auto exact_xs = xs, exact_ys = ys;
  bend(exact_xs, exact_ys);
  patches.apply(xs, ys);
  EXPECT_EQ(patches.patches(), 2u);
  EXPECT_EQ(patches.refused(), 1u);
  EXPECT_EQ(xs[1], exact_xs[1]);
  EXPECT_EQ(xs[2], exact_xs[2]);
  EXPECT_NEAR(xs[0], exact_xs[0], 1e-9);
  EXPECT_NEAR(ys[3], exact_ys[3], 1e-9);
}

TEST(TransformPatches, HandsNumbersWithoutACellToTheExactTransformation) {
  TransformPatches patches(bend, 100.0);
  std::vector<double> xs{1e300, std::numeric_limits<double>::quiet_NaN()}, ys{0.0, 0.0};
  patches.apply(xs, ys);
  EXPECT_EQ(patches.patches() + patches.refused(), 0u);
  EXPECT_EQ(xs[0], 3e300);
  EXPECT_TRUE(std::isnan(xs[1]));
}

TEST(TransformPatches, TakesEqualPointsToEqualPoints) {
  TransformPatches whole(bend, 100.0), piecewise(bend, 100.0);
  std::vector<double> xs, ys;
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    xs.push_back(random.uniform(-1000.0, 1000.0));
    ys.push_back(random.uniform(-1000.0, 1000.0));
  }
  auto one_xs = xs, one_ys = ys;
  whole.apply(xs, ys);
  for (std::size_t i = one_xs.size(); i-- > 0;) {
    piecewise.apply(std::span(one_xs).subspan(i, 1), std::span(one_ys).subspan(i, 1));
  }
  EXPECT_EQ(xs, one_xs);
  EXPECT_EQ(ys, one_ys);
}

// Cells whose sides are powers of two take points together; which ones must not matter to any.
TEST(TransformPatches, TakesPointsTogetherAsItTakesThemOneByOne) {
  TransformPatches together(bend, 128.0), apart(bend, 128.0);
  std::vector<double> xs, ys;
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const bool on_edge = i % 5 == 0;
    const double x = random.uniform(-600.0, 600.0);
    xs.push_back(on_edge ? 128.0 * std::round(x / 128.0) : x);
    ys.push_back(i % 3 == 0 && i > 0 ? ys.back() : random.uniform(-300.0, 300.0));
  }
  auto one_xs = xs, one_ys = ys;
  together.apply(xs, ys);
  for (std::size_t i = one_xs.size(); i-- > 0;) {
    apart.apply(std::span(one_xs).subspan(i, 1), std::span(one_ys).subspan(i, 1));
  }
  EXPECT_EQ(xs, one_xs);
  EXPECT_EQ(ys, one_ys);
}

TEST(TransformPatches, TakesPointsNearbyAsItTakesAll) {
  TransformPatches patches(bend, 128.0);
  std::vector<double> first_x{5.0}, first_y{5.0};
  EXPECT_FALSE(patches.apply_in_last_cell(first_x, first_y, 1e6)) << "there is no last cell";
  patches.apply(first_x, first_y);
  const std::vector<double> xs{1.0, 127.9, 64.0, 0.0, 3.0}, ys{2.0, 0.0, 127.0, 0.0, 9.0};
  auto nearby_xs = xs, nearby_ys = ys, all_xs = xs, all_ys = ys;
  EXPECT_TRUE(patches.apply_in_last_cell(nearby_xs, nearby_ys, 1e6));
  patches.apply(all_xs, all_ys);
  EXPECT_EQ(nearby_xs, all_xs);
  EXPECT_EQ(nearby_ys, all_ys);
  for (const double stranger : {128.0, -0.1, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()}) {
    std::vector<double> some_xs{1.0, stranger}, some_ys{1.0, 1.0};
    EXPECT_FALSE(patches.apply_in_last_cell(some_xs, some_ys, 1e6));
    EXPECT_EQ(some_xs[0], 1.0);
  }
  double farthest = 0.0;
  for (const double x : all_xs) farthest = std::max(farthest, std::abs(x));
  for (const double y : all_ys) farthest = std::max(farthest, std::abs(y));
  auto far_xs = xs, far_ys = ys;
  EXPECT_FALSE(patches.apply_in_last_cell(far_xs, far_ys, 0.9 * farthest));
  EXPECT_EQ(far_xs, xs);
}

}  // namespace
}  // namespace mapwright::converter
