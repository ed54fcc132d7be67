// docs/decisions/0010-orientation-of-outlines.md, case by case.
#include <gtest/gtest.h>

#include "tests/validators/shapes.hpp"

namespace mapwright::test {
namespace {

constexpr Box kLarge{0, 0, 20, 20};
constexpr Box kMiddle{2, 2, 18, 18};
constexpr Box kSmall{5, 5, 6, 6};

TEST(Orientation, OfASolidIsCounterClockwise) {
  EXPECT_EQ(found_in({solid(1, kSmall)}), "");
  EXPECT_EQ(found_in({hollow(1, kSmall)}), "G107:1 ");
  EXPECT_EQ(found_in({solid(1, kSmall), hollow(2, {8, 8, 9, 9})}), "G107:2 ");
}

TEST(Orientation, OfACourtyardIsClockwise) {
  EXPECT_EQ(found_in({solid(1, kLarge), hollow(2, kMiddle)}), "");
  EXPECT_EQ(found_in({solid(1, kLarge), hollow(2, kMiddle, "yard,inner_of=1")}), "");
  EXPECT_EQ(found_in({solid(1, kLarge), ring(2, corners(kMiddle), "yard,inner_of=1")}),
            "G107:2 G124:2 ");
}

TEST(Orientation, OfTheOutlineAroundACourtyardIsCounterClockwise) {
  EXPECT_EQ(found_in({hollow(1, kLarge), hollow(2, kMiddle, "yard,inner_of=1")}), "G107:1 ");
  EXPECT_EQ(found_in({hollow(1, kLarge), hollow(2, kMiddle, "yard,inner_of=1"), solid(3, kSmall)}),
            "G107:1 ");
  EXPECT_EQ(found_in({hollow(1, kLarge), hollow(2, kMiddle), solid(3, kSmall)}), "G107:1 ");
}

TEST(Orientation, OfARoomWithFurnitureIsFree) {
  EXPECT_EQ(found_in({hollow(1, kLarge), solid(2, kSmall)}), "");
  EXPECT_EQ(found_in({hollow(1, kLarge), wall(2, {{5, 5}, {6, 5}})}), "");
  EXPECT_EQ(found_in({hollow(1, kLarge), hollow(2, kSmall)}), "G107:2 ");
}

TEST(Orientation, OfAnEmptyIndoorRoomIsFree) {
  EXPECT_EQ(found_in({hollow(1, kSmall, "room", InOut::kIndoor)}), "");
  EXPECT_EQ(found_in({hollow(1, kLarge), hollow(2, kSmall, "column", InOut::kIndoor)}),
            "G107:2 S126:2.1 ");
}

TEST(Orientation, OfAnEmptyYardThatFillsTheMapIsFree) {
  EXPECT_EQ(found_in({hollow(1, {-40, -40, 40, 40})}), "");
}

TEST(Orientation, OfARampIsCounterClockwise) {
  const Points footprint{{0, 0}, {4, 0}, {4, 2}, {0, 2}, {0, 0}};
  const char* normal = "ramp,normal=-0.0995:0:0.995";
  EXPECT_EQ(found_in({chain(1, ShapeType::kRamp, footprint, 0.0, normal)}), "");
  EXPECT_EQ(found_in({chain(1, ShapeType::kRamp, reversed(footprint), 0.0, normal)}), "G107:1 ");
}

TEST(Orientation, OfACurveIsCheckedToo) {
  Points points = corners(kSmall);
  points.push_back(points.front());
  EXPECT_EQ(found_in({chain(1, ShapeType::kClosedCurve, points)}), "");
  EXPECT_EQ(found_in({chain(1, ShapeType::kClosedCurve, reversed(points))}), "G107:1 ");
}

TEST(LeaningWalls, HaveTheirFreeSideWhereTheOutlineHasIt) {
  EXPECT_EQ(found_in({solid(1, kLarge), wall(2, {{5, 0}, {8, 0}})}), "");
  EXPECT_EQ(found_in({solid(1, kLarge), wall(2, {{8, 0}, {5, 0}})}), "G107:2.1 ");
  EXPECT_EQ(found_in({solid(1, kLarge), wall(2, {{10, -5}, {10, 0}, {5, 0}})}), "G107:2.2 ");
  EXPECT_EQ(found_in({solid(1, kLarge), wall(2, {{8, 0}, {8, -5}})}), "");
}

TEST(LeaningWalls, AreLongerThanWhatLeansOnThem) {
  EXPECT_EQ(found_in({solid(1, {5, 0, 6, 1}), wall(2, {{20, 0}, {0, 0}})}), "");
  EXPECT_EQ(found_in({solid(1, {5, 0, 6, 1}), wall(2, {{0, 1}, {20, 1}})}), "");
}

TEST(LeaningWalls, MayLieOnSeveralEdges) {
  const Points corners{{0, 0}, {3, 0}, {7, 0}, {20, 0}, {20, 20}, {0, 20}};
  EXPECT_EQ(found_in({ring(1, corners), wall(2, {{1, 0}, {9, 0}})}), "");
  EXPECT_EQ(found_in({ring(1, corners), wall(2, {{9, 0}, {1, 0}})}), "G107:2.1 ");
}

TEST(LeaningWalls, BetweenTwoSolidsMayRunAnyWay) {
  const auto left = solid(1, {0, 0, 5, 5}), right = solid(2, {5, 0, 9, 5});
  EXPECT_EQ(found_in({left, right, wall(3, {{5, 1}, {5, 4}})}), "");
  EXPECT_EQ(found_in({left, right, wall(3, {{5, 4}, {5, 1}})}), "");
}

TEST(LeaningWalls, OnTheBorderFaceTheMap) {
  EXPECT_EQ(found_in({wall(1, {{50, 5}, {50, 0}})}), "");
  EXPECT_EQ(found_in({wall(1, {{50, 0}, {50, 5}})}), "G107:1.1 ");
  EXPECT_EQ(found_in({wall(1, {{50, 0}, {40, 0}})}), "");
}

}  // namespace
}  // namespace mapwright::test
