#include "converter/exporters/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/converter/png_image.hpp"

namespace mapwright::converter {
namespace {

Obstacle chain(std::int64_t id, ShapeType type, const std::vector<Point>& points, double height_m,
               const char* semantic = "") {
  Obstacle obstacle{id, type, Semantic(semantic), {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    obstacle.segments.push_back({points[i], points[i + 1], height_m, InOut::kOutdoor, {}});
  }
  return obstacle;
}

Obstacle box(std::int64_t id, double x, double y, double size, double height_m,
             const char* semantic = "") {
  return chain(id, ShapeType::kClosedPolygon,
               {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}, {x, y}}, height_m,
               semantic);
}

Map empty_site() {
  return {{0.0, 20.0, 20.0, 0.0}, {}};
}

// A plain picture of 20 m x 20 m: nothing but the shapes.
PictureOptions plain() {
  PictureOptions options;
  options.window = Box{0.0, 0.0, 20.0, 20.0};
  options.width_px = 800;
  options.labels = PictureLabels::kNone;
  options.orientation_ticks = false;
  return options;
}

test::PngImage drawn(const Map& map, const PictureOptions& options, const Overlay& overlay = {}) {
  const auto bytes = draw_picture(map, overlay, options, PictureFormat::kPng);
  EXPECT_TRUE(bytes.has_value());
  return test::PngImage(bytes.value_or(""));
}

Overlay with(OverlayItem item) {
  Overlay overlay;
  overlay.items.push_back(std::move(item));
  return overlay;
}

TEST(Picture, KnowsFormatsByExtension) {
  EXPECT_EQ(picture_format("a/b.svg"), PictureFormat::kSvg);
  EXPECT_EQ(picture_format("b.PNG"), PictureFormat::kPng);
  EXPECT_EQ(picture_format("x.y.pdf"), PictureFormat::kPdf);
  EXPECT_EQ(picture_format("b.webp"), PictureFormat::kWebp);
  EXPECT_EQ(picture_format("b.jpg"), std::nullopt);
  EXPECT_EQ(picture_format("svg"), std::nullopt);
}

TEST(Picture, SameMapGivesTheSameBytes) {
  Map map = empty_site();
  map.obstacles = {box(1, 2, 2, 6, 10), box(2, 12, 2, 1, 0.5, "bench")};
  PictureOptions options;
  options.title = "Site";
  for (const auto format : {PictureFormat::kSvg, PictureFormat::kPng, PictureFormat::kPdf}) {
    const auto first = draw_picture(map, {}, options, format);
    const auto second = draw_picture(map, {}, options, format);
    ASSERT_TRUE(first && second);
    EXPECT_GT(first->size(), 1000U);
    EXPECT_EQ(*first, *second);
  }
}

TEST(Picture, BeginsAsItsFormatDoes) {
  const Map map = empty_site();
  EXPECT_EQ(draw_picture(map, {}, {}, PictureFormat::kSvg)->substr(0, 5), "<?xml");
  EXPECT_EQ(draw_picture(map, {}, {}, PictureFormat::kPng)->substr(1, 3), "PNG");
  EXPECT_EQ(draw_picture(map, {}, {}, PictureFormat::kPdf)->substr(0, 5), "%PDF-");
}

TEST(Picture, PdfHoldsNoDateOfToday) {
  const auto pdf = draw_picture(empty_site(), {}, {}, PictureFormat::kPdf);
  EXPECT_NE(pdf->find("/CreationDate (20000101"), std::string::npos);
}

TEST(Picture, HasTheWidthAskedFor) {
  EXPECT_EQ(drawn(empty_site(), plain()).width(), 800);
  PictureOptions wide = plain();
  wide.width_px = 2000;
  EXPECT_EQ(drawn(empty_site(), wide).width(), 2000);
}

TEST(Picture, FillsAnOutlineButNotItsCourtyard) {
  Map solid = empty_site();
  solid.obstacles = {box(7, 5, 5, 10, 12)};
  Map with_courtyard = solid;
  with_courtyard.obstacles.push_back(chain(8, ShapeType::kClosedPolygon,
                                           {{8, 8}, {8, 13}, {13, 13}, {13, 8}, {8, 8}}, 12,
                                           "inner_of=7"));
  const auto paper = drawn(empty_site(), plain());
  const double solid_share = drawn(solid, plain()).difference(paper).count();
  const double courtyard_share = drawn(with_courtyard, plain()).difference(paper).count();
  EXPECT_NEAR(courtyard_share / solid_share, 75.0 / 100.0, 0.06);
}

TEST(Picture, TicksStandOnTheFreeSide) {
  Map map = empty_site();
  map.obstacles = {chain(1, ShapeType::kOpenPolygon, {{2, 10}, {18, 10}}, 2.0)};
  PictureOptions ticked = plain();
  ticked.orientation_ticks = true;
  const auto without = drawn(map, plain());
  const auto wall = without.difference(drawn(empty_site(), plain())).within_panel(0.85);
  const auto ticks = without.difference(drawn(map, ticked)).within_panel(0.85);
  ASSERT_GT(wall.count(), 0);
  ASSERT_GT(ticks.count(), 0);
  // The wall runs along +x, so its free side, the right, is below it on the page.
  EXPECT_GE(ticks.min_y(), wall.min_y());
  EXPECT_GT(ticks.max_y(), wall.max_y());
}

TEST(Picture, OverlaysLieWhereTheyBelong) {
  const auto paper = drawn(empty_site(), plain());
  const auto at = [&](Point p) {
    const OverlayDots dot{{p}, 3.0, Colour::from_hex(0xFF0000)};
    return drawn(empty_site(), plain(), with(dot)).difference(paper);
  };
  const auto low_left = at({5, 5});
  const auto high_right = at({15, 15});
  ASSERT_GT(low_left.count(), 0);
  EXPECT_LT(low_left.max_x(), high_right.min_x());
  EXPECT_GT(low_left.min_y(), high_right.max_y());
}

TEST(Picture, AFieldShowsOnRampsAndNotInBuildings) {
  Overlay everywhere;
  everywhere.field = ColourField{{0.0, 0.0}, 20.0, 1, {Colour::from_hex(0xFF0000)}};
  const auto changed = [&](Obstacle obstacle) {
    Map map = empty_site();
    map.obstacles = {std::move(obstacle)};
    return drawn(map, plain(), everywhere)
        .difference(drawn(empty_site(), plain(), everywhere))
        .within_panel(0.85)
        .count();
  };
  const auto under_building = changed(box(1, 5, 5, 10, 12));
  Obstacle ramp = box(1, 5, 5, 10, 0, "ramp,normal=-0.08:0:0.9968");
  ramp.shape_type = ShapeType::kRamp;
  EXPECT_GT(under_building, 10'000);
  EXPECT_LT(changed(ramp), under_building / 8);  // its outline and its arrow
}

TEST(Picture, EveryOverlayItemLeavesAMark) {
  const auto paper = drawn(empty_site(), plain());
  const Stroke red{Colour::from_hex(0xFF0000), 1.0};
  const std::vector<OverlayItem> items = {
      OverlayPath{{{2, 2}, {9, 9}}, red},
      OverlaySegments{{{{2, 2}, {9, 9}}}, red},
      OverlayDots{{{4, 4}}, 2.0, red.colour},
      OverlayCircle{{10, 10}, 3.0, red},
      OverlayPose{{10, 10, Angle::from_degrees(30)}, 4.0, red.colour},
      OverlayMarker{{10, 10}, "G104", red.colour}};
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_GT(drawn(empty_site(), plain(), with(items[i])).difference(paper).count(), 10) << i;
  }
}

TEST(Picture, LegendNamesWhatTheOverlayAdds) {
  Overlay overlay;
  overlay.legend.push_back({OverlayDots{{}, 2.0, Colour::from_hex(0xFF0000)}, "particle"});
  const auto with_entry = drawn(empty_site(), plain(), overlay);
  EXPECT_GT(with_entry.difference(drawn(empty_site(), plain())).count(), 20);
}

TEST(Picture, RefusesAWindowWithoutArea) {
  PictureOptions options = plain();
  options.window = Box{5, 5, 5, 10};
  const auto picture = draw_picture(empty_site(), {}, options, PictureFormat::kPng);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().kind, FailureKind::kUsage);
}

TEST(Picture, RefusesCoordinatesThatAreNoLocalFrame) {
  Map map = empty_site();
  map.obstacles = {box(1, 1e9, 1e9, 5, 3)};
  EXPECT_FALSE(draw_picture(map, {}, {}, PictureFormat::kPng));
}

TEST(Picture, SkipsObstaclesWithoutFiniteCoordinates) {
  Map map = empty_site();
  Obstacle broken = box(1, 2, 2, 5, 3);
  broken.segments[1].a.x = std::numeric_limits<double>::quiet_NaN();
  map.obstacles = {broken, Obstacle{2, ShapeType::kStairs, {}, {}}};
  const auto changed = drawn(map, plain()).difference(drawn(empty_site(), plain()));
  EXPECT_EQ(changed.count(), 0);
}

TEST(Picture, DrawsWhatReachesFarBeyondTheWindow) {
  Map map = empty_site();
  map.obstacles = {chain(1, ShapeType::kOpenPolygon, {{-9e5, 10}, {9e5, 10}}, 2.0)};
  const auto wall = drawn(map, plain()).difference(drawn(empty_site(), plain())).within_panel(0.9);
  EXPECT_GT(wall.max_x() - wall.min_x(), 500);
  EXPECT_LT(wall.max_y() - wall.min_y(), 8);
}

}  // namespace
}  // namespace mapwright::converter
