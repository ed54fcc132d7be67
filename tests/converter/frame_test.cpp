// The map frame against PROJ, by way of the WKT that other programs read.
#include <gtest/gtest.h>

#include <ogr_spatialref.h>
#include <array>

#include <cmath>
#include <memory>

#include "converter/frame/frame_wkt.hpp"
#include "converter/frame/local_frame.hpp"
#include "converter/frame/origin.hpp"
#include "mapcore/random.hpp"

namespace mapwright::converter {
namespace {

Georeference campus(FrameProjection projection, double heading_deg, double height_m) {
  Georeference g;
  g.origin_latitude_deg = 41.3882;
  g.origin_longitude_deg = 2.1125;
  g.origin_height_m = height_m;
  g.heading_deg = heading_deg;
  g.projection = projection;
  return g;
}

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation by_wkt(const Georeference& g) {
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference map;
  EXPECT_EQ(map.importFromWkt(frame_wkt2(g).c_str()), OGRERR_NONE);
  map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return Transformation(OGRCreateCoordinateTransformation(&wgs84, &map));
}

struct FrameCase {
  FrameProjection projection;
  double heading_deg, height_m, reach_m, tolerance_m;
};

class Frame : public testing::TestWithParam<FrameCase> {};

TEST_P(Frame, AgreesWithProjThroughItsWkt) {
  const auto& c = GetParam();
  const auto g = campus(c.projection, c.heading_deg, c.height_m);
  const LocalFrame frame(g);
  const auto proj = by_wkt(g);
  ASSERT_NE(proj, nullptr);
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Point p{random.uniform(-c.reach_m, c.reach_m), random.uniform(-c.reach_m, c.reach_m)};
    const GeoPoint place = frame.to_wgs84(p);
    const Point back = frame.to_map(place);
    EXPECT_LT(distance(p, back), 1e-6);
    double x = place.longitude_deg;
    double y = place.latitude_deg;
    ASSERT_TRUE(proj->Transform(1, &x, &y));
    EXPECT_LT(distance(p, {x, y}), c.tolerance_m) << p.x << ", " << p.y;
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllFrames, Frame,
    testing::Values(FrameCase{FrameProjection::kTransverseMercator, 0.0, 0.0, 10000.0, 1e-3},
                    FrameCase{FrameProjection::kTransverseMercator, -20.6, 0.0, 10000.0, 1e-3},
                    FrameCase{FrameProjection::kTransverseMercator, 135.0, 120.0, 10000.0, 1e-3},
                    FrameCase{FrameProjection::kEastNorthUp, 0.0, 0.0, 10000.0, 1e-3},
                    FrameCase{FrameProjection::kEastNorthUp, 33.0, 650.0, 10000.0, 1e-3}));

TEST(FrameAxes, HeadingTurnsYClockwiseFromNorth) {
  const LocalFrame frame(campus(FrameProjection::kTransverseMercator, 90.0, 0.0));
  const Point north = frame.to_map(GeoPoint{2.1125, 41.3892});
  EXPECT_NEAR(north.x, -111.06, 0.05);  // +y points east, so north is on the left
  EXPECT_NEAR(north.y, 0.0, 1e-6);
}

TEST(FrameAxes, GridScaleIsTakenOut) {
  // 1000 m of UTM at the central meridian are 1000 / 0.9996 m on the ellipsoid.
  const auto crs = parse_crs("EPSG:25831");
  ASSERT_TRUE(crs.has_value());
  const auto transform = CrsTransform::create(*crs);
  ASSERT_TRUE(transform.has_value());
  FrameOptions options;
  options.origin = {500000.0, 4582000.0};
  options.origin_crs = "EPSG:25831";
  const auto g = resolve_frame(options, 0.0, 0.0);
  ASSERT_TRUE(g.has_value());
  EXPECT_NEAR(g->heading_deg, 0.0, 1e-9);
  double x = 501000.0;
  double y = 4582000.0;
  transform->to_wgs84({&x, 1}, {&y, 1});
  EXPECT_NEAR(LocalFrame(*g).to_map(GeoPoint{x, y}).x, 1000.0 / 0.9996, 1e-4);
}

// A registered CRS is taken from the registry: that must not move a point. Their datums have
// members, several ways lead to WGS 84, or the stated one is not the registered one.
TEST(FrameAxes, RegisteredAndStatedCrsAreOne) {
  for (const auto* code : {"EPSG:25831", "EPSG:32631", "EPSG:3857", "EPSG:2062", "EPSG:23031",
                           "EPSG:27700", "EPSG:31370", "EPSG:4258", "EPSG:2154"}) {
    auto crs = parse_crs(code);
    ASSERT_TRUE(crs.has_value()) << code;
    const auto registered = CrsTransform::create(*crs);
    crs->code.clear();
    const auto stated = CrsTransform::create(*crs);
    ASSERT_TRUE(registered.has_value() && stated.has_value()) << code;
    std::array<double, 2> x{crs->geographic ? 2.1 : 428000.25, crs->geographic ? 4.2 : 512345.5};
    std::array<double, 2> y{crs->geographic ? 41.4 : 458000.75, crs->geographic ? 50.1 : 180123.5};
    auto stated_x = x, stated_y = y;
    registered->to_wgs84(x, y);
    stated->to_wgs84(stated_x, stated_y);
    EXPECT_EQ(x, stated_x) << code;
    EXPECT_EQ(y, stated_y) << code;
  }
}

// Nor may a code that the stated CRS does not keep to.
TEST(FrameAxes, StatedCrsIsHeldAgainstItsCode) {
  auto crs = parse_crs("EPSG:25831");
  ASSERT_TRUE(crs.has_value());
  auto other = parse_crs("EPSG:25830");
  ASSERT_TRUE(other.has_value());
  other->code = "EPSG:25831";
  const auto transform = CrsTransform::create(*other);
  ASSERT_TRUE(transform.has_value());
  double x = 500000.0, y = 4582000.0;
  transform->to_wgs84({&x, 1}, {&y, 1});
  EXPECT_NEAR(x, -3.0, 1e-9) << "the central meridian of zone 30";
}

TEST(FrameAxes, HeadingCountsFromTheGridOfTheOrigin) {
  FrameOptions options;
  options.origin = {425800.0, 4582230.0};
  options.origin_crs = "EPSG:25831";
  options.heading_deg = -20.0;
  const auto g = resolve_frame(options, 0.0, 0.0);
  ASSERT_TRUE(g.has_value());
  // Meridian convergence there: (2.1125 − 3) · sin 41.388° = −0.5868°.
  EXPECT_NEAR(g->heading_deg, -20.5868, 2e-4);
  EXPECT_NEAR(g->origin_latitude_deg, 41.38818, 1e-5);
}

TEST(FrameAxes, RefusesImpossibleOrigins) {
  FrameOptions options;
  options.origin = {2.1, 41.4};
  EXPECT_TRUE(resolve_frame(options, 0.0, 0.0).has_value());
  options.origin = {425800.0, 4582230.0};
  const auto refused = resolve_frame(options, 0.0, 0.0);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, FailureKind::kUsage);
}

}  // namespace
}  // namespace mapwright::converter
