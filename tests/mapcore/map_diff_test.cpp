#include "mapcore/diff/map_diff.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/support/campus_generator.hpp"
#include "mapcore/random.hpp"

namespace mapwright {
namespace {

Obstacle ring(std::int64_t id, const std::vector<Point>& points, const char* semantic = "building",
              double height_m = 3.0) {
  Obstacle obstacle{id, ShapeType::kClosedPolygon, semantic, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    obstacle.segments.push_back(
        {points[i], points[(i + 1) % points.size()], height_m, InOut::kOutdoor, "wall"});
  }
  return obstacle;
}

Obstacle box(std::int64_t id, double x, double y, double size = 2.0) {
  return ring(id, {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
}

Map map_of(std::vector<Obstacle> obstacles) {
  return {{0.0, 100.0, 100.0, 0.0}, std::move(obstacles)};
}

Obstacle shifted(Obstacle obstacle, Point by) {
  for (auto& segment : obstacle.segments) {
    segment.a = segment.a + by;
    segment.b = segment.b + by;
  }
  return obstacle;
}

const Map& campus() {
  static const Map map = bench::generate_campus({200.0, 2000, 3});
  return map;
}

TEST(MapDiff, OfAMapWithItselfIsEmpty) {
  const auto diff = diff_maps(campus(), campus());
  EXPECT_TRUE(diff.same());
  EXPECT_TRUE(diff.changes.empty());
  EXPECT_EQ(diff.counts.unchanged, campus().obstacles.size());
  EXPECT_TRUE(diff_maps({}, {}).same());
}

TEST(MapDiff, OtherNumbersAndAnotherOrderAreNoDifference) {
  Map other = campus();
  Random random(1);
  for (std::size_t i = other.obstacles.size(); i > 1; --i) {
    std::swap(other.obstacles[i - 1], other.obstacles[random.below(i)]);
  }
  std::int64_t id = 5000;
  for (auto& obstacle : other.obstacles) obstacle.id = id++;
  const auto diff = diff_maps(campus(), other);
  EXPECT_TRUE(diff.same());
  EXPECT_EQ(diff.counts.renumbered, campus().obstacles.size());
  EXPECT_EQ(diff.counts.unchanged, campus().obstacles.size());
}

TEST(MapDiff, RingsMayBeginAtAnotherVertex) {
  Map other = map_of({box(1, 3, 3)});
  std::rotate(other.obstacles[0].segments.begin(), other.obstacles[0].segments.begin() + 2,
              other.obstacles[0].segments.end());
  EXPECT_TRUE(diff_maps(map_of({box(1, 3, 3)}), other).changes.empty());
}

TEST(MapDiff, InnerRingsFollowTheirOutlinesNumber) {
  Map before = map_of({box(1, 0, 0, 10), box(2, 3, 3)});
  before.obstacles[1].semantic = "court,inner_of=1";
  Map after = before;
  after.obstacles[0].id = 70;
  after.obstacles[1].semantic = "court,inner_of=70";
  EXPECT_TRUE(diff_maps(before, after).same());
  after.obstacles[1].semantic = "court,inner_of=71";
  EXPECT_FALSE(diff_maps(before, after).same());
}

TEST(MapDiff, FindsWhatWasAddedAndRemoved) {
  const auto diff = diff_maps(map_of({box(1, 3, 3), box(2, 40, 40)}),
                              map_of({box(2, 40, 40), box(3, 70, 70, 5)}));
  ASSERT_EQ(diff.changes.size(), 2U);
  EXPECT_TRUE(diff.changes[0].removed());
  EXPECT_EQ(diff.changes[0].before, 0U);
  EXPECT_TRUE(diff.changes[1].added());
  EXPECT_EQ(diff.changes[1].after, 1U);
  EXPECT_FALSE(diff.same());
}

TEST(MapDiff, SaysHowFarAnObstacleMoved) {
  for (const std::int64_t new_id : {1, 9}) {
    const auto diff = diff_maps(map_of({box(1, 3, 3), box(2, 40, 40)}),
                                map_of({box(new_id, 3.3, 2.6), box(2, 40, 40)}));
    ASSERT_EQ(diff.changes.size(), 1U);
    EXPECT_TRUE(diff.changes[0].moved);
    EXPECT_FALSE(diff.changes[0].reshaped);
    EXPECT_EQ(diff.changes[0].renumbered, new_id == 9);
    EXPECT_NEAR(diff.changes[0].offset.x, 0.3, 1e-12);
    EXPECT_NEAR(diff.changes[0].offset.y, -0.4, 1e-12);
  }
}

TEST(MapDiff, WithAnotherNumberFarOffItIsAnotherObstacle) {
  const Map before = map_of({box(1, 3, 3)});
  EXPECT_EQ(diff_maps(before, map_of({box(9, 60, 60)})).counts.added, 1U);
  EXPECT_EQ(diff_maps(before, map_of({box(1, 60, 60)})).counts.moved, 1U);
  EXPECT_EQ(diff_maps(before, map_of({box(9, 60, 60)}), {0.0, 100.0}).counts.moved, 1U);
}

TEST(MapDiff, AShiftOfTheWholeMapIsFoundThroughOtherNumbers) {
  Map other = campus();
  std::int64_t id = 5000;
  for (auto& obstacle : other.obstacles) {
    obstacle = shifted(obstacle, {250.0, -31.5});
    obstacle.id = id++;
  }
  const auto diff = diff_maps(campus(), other);
  EXPECT_EQ(diff.counts.moved, campus().obstacles.size());
  for (const auto& change : diff.changes) {
    EXPECT_EQ(change.before, change.after);
    EXPECT_NEAR(change.offset.x, 250.0, 1e-9);
    EXPECT_NEAR(change.offset.y, -31.5, 1e-9);
  }
}

TEST(MapDiff, SaysHowMuchAShapeChanged) {
  const auto diff = diff_maps(map_of({box(1, 3, 3, 4)}),
                              map_of({ring(8, {{3, 3}, {7, 3}, {7, 7}, {5, 7.5}, {3, 7}})}));
  ASSERT_EQ(diff.changes.size(), 1U);
  EXPECT_TRUE(diff.changes[0].reshaped);
  EXPECT_FALSE(diff.changes[0].moved);
  EXPECT_NEAR(diff.changes[0].deviation_m, 0.5, 1e-12);
  EXPECT_TRUE(diff.changes[0].attributes.empty());
}

TEST(MapDiff, TurnedRoundIsAnotherShape) {
  const Map before = map_of({box(1, 3, 3)});
  const Map after = map_of({ring(1, {{3, 3}, {3, 5}, {5, 5}, {5, 3}})});
  const auto diff = diff_maps(before, after);
  ASSERT_EQ(diff.changes.size(), 1U);
  EXPECT_TRUE(diff.changes[0].reshaped);
  EXPECT_TRUE(diff.changes[0].reversed);
  EXPECT_EQ(diff.changes[0].deviation_m, 0.0);
}

TEST(MapDiff, NamesAttributesAndTheirSegments) {
  Map after = map_of({box(1, 3, 3)});
  after.obstacles[0].semantic = "kiosk";
  after.obstacles[0].shape_type = ShapeType::kClosedCurve;
  after.obstacles[0].segments[1].height_m = 4.0;
  after.obstacles[0].segments[3].height_m = 4.0;
  after.obstacles[0].segments[2].in_out = InOut::kIndoor;
  after.obstacles[0].segments[0].semantic = "door";
  const auto diff = diff_maps(map_of({box(1, 3, 3)}), after);
  ASSERT_EQ(diff.changes.size(), 1U);
  EXPECT_EQ(diff.changes[0].attributes,
            (std::vector<AttributeChange>{{"shape_type", "1", "3", {}},
                                          {"semantic", "building", "kiosk", {}},
                                          {"segment_semantic", "wall", "door", {1}},
                                          {"height_m", "3", "4", {2, 4}},
                                          {"in_out", "outdoor", "indoor", {3}}}));
  EXPECT_FALSE(diff.changes[0].moved);
}

TEST(MapDiff, OfAnotherNumberOfSegmentsComparesAllValues) {
  const auto diff = diff_maps(map_of({box(1, 3, 3)}),
                              map_of({ring(1, {{3, 3}, {5, 3}, {4, 5}}, "building", 2.5)}));
  ASSERT_EQ(diff.changes.size(), 1U);
  EXPECT_EQ(diff.changes[0].attributes,
            (std::vector<AttributeChange>{{"height_m", "3", "2.5", {}}}));
}

TEST(MapDiff, ToleranceCoversRounding) {
  Map after = map_of({ring(1, {{3.004, 2.996}, {5, 3}, {5.002, 5}, {2.998, 5}})});
  const Map before = map_of({box(1, 3, 3)});
  EXPECT_EQ(diff_maps(before, after).counts.reshaped, 1U);
  EXPECT_TRUE(diff_maps(before, after, {0.01, 10.0}).same());
}

TEST(MapDiff, TwinsAtOnePlaceStayApart) {
  const Map before = map_of({box(1, 3, 3), box(2, 3, 3)});
  EXPECT_TRUE(diff_maps(before, map_of({box(2, 3, 3), box(1, 3, 3)})).changes.empty());
  EXPECT_EQ(diff_maps(before, map_of({box(2, 3, 3)})).counts.removed, 1U);
}

TEST(MapDiff, ComparesBorders) {
  Map after = map_of({});
  after.border.right = 120.0;
  const auto diff = diff_maps(map_of({}), after);
  EXPECT_FALSE(diff.same());
  EXPECT_EQ(diff.border_before->right, 100.0);
  EXPECT_EQ(diff.border_after->right, 120.0);
}

// Many edits at once: each obstacle is found again, and what was done to it.
TEST(MapDiff, FindsRandomEdits) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Map after = campus();
    MapDiffCounts expected;
    for (std::size_t i = 0; i < after.obstacles.size(); ++i) {
      auto& obstacle = after.obstacles[i];
      const auto what = random.below(10);
      if (what == 0) {
        obstacle = shifted(obstacle, {0.25, random.uniform(-0.5, 0.5)});
        ++expected.moved;
      } else if (what == 1) {
        for (auto& segment : obstacle.segments) segment.height_m += 0.5;
        ++expected.reattributed;
      } else if (what == 2) {
        obstacle.id += 100000;
        ++expected.renumbered;
      }
    }
    const auto diff = diff_maps(campus(), after);
    EXPECT_EQ(diff.counts.added, 0U);
    EXPECT_EQ(diff.counts.removed, 0U);
    EXPECT_EQ(diff.counts.reshaped, 0U);
    EXPECT_EQ(diff.counts.moved, expected.moved);
    EXPECT_EQ(diff.counts.reattributed, expected.reattributed);
    EXPECT_EQ(diff.counts.renumbered, expected.renumbered);
    for (const auto& change : diff.changes) EXPECT_EQ(change.before, change.after);
  }
}

}  // namespace
}  // namespace mapwright
