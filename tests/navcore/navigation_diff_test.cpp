#include "navcore/diff/navigation_diff.hpp"

#include <gtest/gtest.h>

#include "bench/support/campus_generator.hpp"

namespace mapwright::navcore {
namespace {

// A yard of 20 m by 10 m, in two halves but for a door of the given width at the lower end of the
// wall between them.
Map halves(double door_m) {
  Map map{{0.0, 10.0, 20.0, 0.0}, {}};
  Obstacle wall{1, ShapeType::kOpenPolygon, "wall", {}};
  wall.segments = {{{10.0, door_m}, {10.0, 10.0}, 2.0, InOut::kOutdoor, {}}};
  map.obstacles.push_back(wall);
  return map;
}

NavigationDiff diff(const Map& before, const Map& after, NavigationDiffSettings settings = {}) {
  auto result = diff_navigation(before, after, settings);
  EXPECT_TRUE(result.has_value());
  return *std::move(result);
}

TEST(NavigationDiff, OfAMapWithItselfIsEmpty) {
  const Map campus = bench::generate_campus({100.0, 520, 1});
  const auto same = diff(campus, campus);
  EXPECT_TRUE(same.same());
  EXPECT_EQ(same.scans.sampled, 200U);
  EXPECT_GT(same.routes.tried, 15U);
  EXPECT_GT(same.areas.free_before_m2, 1000.0);
  EXPECT_EQ(same.areas.free_before_m2, same.areas.free_after_m2);
}

TEST(NavigationDiff, AClosedDoorSplitsTheGround) {
  NavigationDiffSettings settings;
  settings.places = {{5.0, 5.0}, {15.0, 5.0}};
  const auto closed = diff(halves(1.0), halves(0.5), settings);
  EXPECT_EQ(closed.routes.impossible, 1U);
  ASSERT_EQ(closed.areas.changed.size(), 1U);
  EXPECT_EQ(closed.areas.changed[0].kind, AreaDifference::Kind::kSplit);
  EXPECT_EQ(closed.areas.changed[0].parts, 2U);
  const auto opened = diff(halves(0.5), halves(1.0), settings);
  EXPECT_EQ(opened.routes.possible, 1U);
  EXPECT_EQ(opened.areas.changed[0].kind, AreaDifference::Kind::kJoined);
  settings.robot_radius_m = 0.2;
  EXPECT_TRUE(diff(halves(1.0), halves(0.5), settings).areas.changed.empty());
}

TEST(NavigationDiff, AWiderDoorMakesWaysShorter) {
  NavigationDiffSettings settings;
  settings.places = {{5.0, 5.0}, {15.0, 5.0}};
  const auto wider = diff(halves(1.0), halves(3.0), settings);
  ASSERT_EQ(wider.routes.shorter, 1U);
  EXPECT_LT(*wider.routes.changed[0].after_m, *wider.routes.changed[0].before_m - 0.5);
  EXPECT_EQ(diff(halves(3.0), halves(1.0), settings).routes.longer, 1U);
}

TEST(NavigationDiff, RoomThatIsFilledVanishes) {
  Map filled = halves(0.0);
  Obstacle block{2, ShapeType::kClosedPolygon, "block", {}};
  const Point corners[] = {{10.0, 0.0}, {20.0, 0.0}, {20.0, 10.0}, {10.0, 10.0}};
  for (int i = 0; i < 4; ++i) {
    block.segments.push_back({corners[i], corners[(i + 1) % 4], 2.0, InOut::kOutdoor, {}});
  }
  filled.obstacles.push_back(block);
  const auto gone = diff(halves(0.0), filled);
  ASSERT_EQ(gone.areas.changed.size(), 1U);
  EXPECT_EQ(gone.areas.changed[0].kind, AreaDifference::Kind::kVanished);
  EXPECT_NEAR(gone.areas.changed[0].area_m2, 9.4 * 9.4, 0.5);
  EXPECT_EQ(diff(filled, halves(0.0)).areas.changed[0].kind, AreaDifference::Kind::kAppeared);
}

TEST(NavigationDiff, LooksCloselyWhereTheMapsDiffer) {
  Map before = bench::generate_campus({1000.0, 52'000, 1});
  Map after = before;
  const Box box = extent(after.obstacles.front());
  after.obstacles.erase(after.obstacles.begin());
  NavigationDiffSettings settings;
  settings.scans = 20;
  settings.routes = 0;
  settings.focus = {box};
  const auto found = diff(before, after, settings);
  EXPECT_EQ(found.scans.sampled_changed, 0U);  // one in 12,475: far from every random place
  EXPECT_EQ(found.scans.focused, 4U);
  EXPECT_GT(found.scans.focused_changed, 0U);
}

TEST(NavigationDiff, FailsWhereThereIsNoGround) {
  EXPECT_FALSE(diff_navigation({}, {}, {}).has_value());
}

}  // namespace
}  // namespace mapwright::navcore
