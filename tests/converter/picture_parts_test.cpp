// The parts of a picture that can be held against numbers.
#include <gtest/gtest.h>

#include "converter/exporters/picture/kinds.hpp"
#include "converter/exporters/picture/labels.hpp"
#include "converter/exporters/picture/shapes.hpp"
#include "converter/exporters/picture/view.hpp"

namespace mapwright::converter {
namespace {

Obstacle ring(ShapeType type, const std::vector<Point>& points, double height_m,
              const char* semantic = "") {
  Obstacle obstacle{1, type, Semantic(semantic), {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    obstacle.segments.push_back(
        {points[i], points[(i + 1) % points.size()], height_m, InOut::kOutdoor, {}});
  }
  return obstacle;
}

const std::vector<Point> kSquare = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};

TEST(PictureView, RoundSteps) {
  EXPECT_DOUBLE_EQ(round_step(7.0), 5.0);
  EXPECT_DOUBLE_EQ(round_step(4.9), 2.0);
  EXPECT_DOUBLE_EQ(round_step(0.13), 0.1);
  EXPECT_DOUBLE_EQ(round_step(2000.0), 2000.0);
}

TEST(PictureView, NumbersWithoutNeedlessDigits) {
  EXPECT_EQ(plain_number(14.0), "14");
  EXPECT_EQ(plain_number(0.45), "0.45");
  EXPECT_EQ(plain_number(0.1 + 0.2), "0.3");
  EXPECT_EQ(plain_number(-1e-9), "0");
}

TEST(PictureView, YRunsDownOnThePage) {
  const View view{{10, 20, 110, 80}, {50, 30, 250, 150}, 2.0};
  EXPECT_EQ(view.to_page(Point{10, 80}), (Point{50, 30}));
  EXPECT_EQ(view.to_page(Point{110, 20}), (Point{250, 150}));
}

TEST(PictureKinds, FollowShapeHeightAndLabels) {
  using enum ObstacleKind;
  const auto kind = [](ShapeType type, double height_m, const char* semantic = "") {
    return obstacle_kind(ring(type, kSquare, height_m, semantic));
  };
  EXPECT_EQ(kind(ShapeType::kClosedPolygon, 10), kBuilding);
  EXPECT_EQ(kind(ShapeType::kClosedCurve, 0.6), kLowSolid);
  EXPECT_EQ(kind(ShapeType::kClosedPolygon, 0.8, "planter,name=P1"), kGreen);
  EXPECT_EQ(kind(ShapeType::kOpenPolygon, 1.8), kWall);
  EXPECT_EQ(kind(ShapeType::kOpenCurve, 0.3), kLowWall);
  EXPECT_EQ(kind(ShapeType::kStairs, 1.0), kStairs);
  EXPECT_EQ(kind(ShapeType::kRamp, 0.0), kRamp);
}

TEST(PictureKinds, SmallAndHighIsAColumnAndClockwiseARoom) {
  EXPECT_EQ(obstacle_kind(ring(ShapeType::kClosedPolygon, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 5)),
            ObstacleKind::kColumn);
  EXPECT_EQ(obstacle_kind(ring(ShapeType::kClosedPolygon, {{0, 0}, {0, 6}, {6, 6}, {6, 0}}, 5)),
            ObstacleKind::kRoom);
}

TEST(PictureShapes, OutlineOfStairsGoesAroundAllSteps) {
  Obstacle stairs{1, ShapeType::kStairs, {}, {}};
  stairs.segments = {{{0, 0}, {4, 0}, 0.2, InOut::kOutdoor, {}},
                     {{0, 1}, {4, 1}, 0.4, InOut::kOutdoor, {}},
                     {{4, 2}, {0, 2}, 0.0, InOut::kOutdoor, {}}};
  EXPECT_EQ(stairs_outline(stairs), (std::vector<Point>{{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
}

TEST(PictureLabels, RoomIsFoundInTheWideArmOfAnL) {
  const std::vector<std::vector<Point>> rings = {
      {{0, 0}, {100, 0}, {100, 30}, {20, 30}, {20, 100}, {0, 100}}};
  const Room room = widest_room(rings, {0, 0, 100, 100}, 8.0);
  EXPECT_DOUBLE_EQ(room.width_pt, 100.0);
  EXPECT_LT(room.middle.y, 26.0);
}

TEST(PictureLabels, RoomAvoidsAHole) {
  const std::vector<std::vector<Point>> rings = {{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                                 {{10, 5}, {90, 5}, {90, 95}, {10, 95}}};
  const Room room = widest_room(rings, {0, 0, 100, 100}, 8.0);
  EXPECT_DOUBLE_EQ(room.width_pt, 10.0);
}

TEST(PictureLabels, NoRoomInWhatIsTooLow) {
  const std::vector<std::vector<Point>> rings = {{{0, 0}, {100, 0}, {100, 5}, {0, 5}}};
  EXPECT_EQ(widest_room(rings, {0, 0, 100, 5}, 8.0).width_pt, 0.0);
}

}  // namespace
}  // namespace mapwright::converter
