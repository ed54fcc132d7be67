#include "mapcore/geometry/segment_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mapcore/geometry/orientation.hpp"
#include "tests/mapcore/geometry/generators.hpp"

namespace mapwright {
namespace {

Box box_around(Point a, Point b) {
  Box box = kEmptyBox;
  box.add(a);
  box.add(b);
  return box;
}

bool meet_closed(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

std::vector<IndexedSegment> random_segments(Random& random, std::size_t count) {
  const auto points = test::random_points(random, 2 * count);
  const bool short_ones = random.below(2) == 0;
  std::vector<IndexedSegment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = points[2 * i];
    const Point b = short_ones ? a + 0.05 * (points[2 * i + 1] - a) : points[2 * i + 1];
    segments.push_back({a, b, static_cast<std::uint32_t>(i)});
  }
  return segments;
}

double segment_distance(Point a, Point b, const IndexedSegment& s) {
  if (meet(a, b, s.a, s.b).kind != Meeting::kNone) return 0.0;
  return std::min({distance(a, closest_point_on_segment(a, s.a, s.b)),
                   distance(b, closest_point_on_segment(b, s.a, s.b)),
                   distance(s.a, closest_point_on_segment(s.a, a, b)),
                   distance(s.b, closest_point_on_segment(s.b, a, b))});
}

double nearest_distance(Point p, const std::vector<IndexedSegment>& segments) {
  double nearest = HUGE_VAL;
  for (const auto& s : segments) {
    nearest = std::min(nearest, distance(p, closest_point_on_segment(p, s.a, s.b)));
  }
  return nearest;
}

std::vector<std::size_t> found_in(const SegmentIndex& index, const Box& box) {
  std::vector<std::size_t> found;
  EXPECT_TRUE(index.query(box, [&](std::size_t i) {
    found.push_back(i);
    return true;
  }));
  std::sort(found.begin(), found.end());
  return found;
}

struct Scene {
  std::vector<IndexedSegment> segments;
  SegmentIndex index;
  std::vector<Point> places;
};

Scene random_scene(Random& random) {
  auto segments = random_segments(random, 1 + random.below(200));
  auto places = test::random_points(random, 20);
  for (std::size_t i = 0; i < 5; ++i) places.push_back(segments[random.below(segments.size())].a);
  SegmentIndex index(segments);
  return {std::move(segments), std::move(index), std::move(places)};
}

template <class Check>
void for_random_scenes(std::uint64_t seed, int scenes, const Check& check) {
  Random random(seed);
  for (int i = 0; i < scenes; ++i) {
    const auto scene = random_scene(random);
    for (std::size_t k = 0; k + 1 < scene.places.size(); ++k) {
      check(scene, scene.places[k], scene.places[k + 1], random);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(SegmentIndex, QueryFindsAllBoxesThatMeet) {
  for_random_scenes(11, 200, [](const Scene& scene, Point a, Point b, Random&) {
    const Box box = box_around(a, b);
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
      const auto& s = scene.segments[i];
      if (meet_closed(box, box_around(s.a, s.b))) expected.push_back(i);
    }
    ASSERT_EQ(found_in(scene.index, box), expected);
  });
}

TEST(SegmentIndex, QueryStopsWhenToldTo) {
  Random random(12);
  const SegmentIndex index(random_segments(random, 100));
  int visits = 0;
  EXPECT_FALSE(index.query({-1e9, -1e9, 1e9, 1e9}, [&](std::size_t) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(SegmentIndex, NearestIsTheNearest) {
  for_random_scenes(13, 300, [](const Scene& scene, Point p, Point, Random&) {
    const auto nearest = scene.index.nearest(p);
    ASSERT_TRUE(nearest.has_value());
    const double expected = nearest_distance(p, scene.segments);
    ASSERT_NEAR(nearest->distance_m, expected, 1e-12 * (1.0 + expected));
    const auto& s = scene.segments[nearest->segment];
    ASSERT_NEAR(distance(p, closest_point_on_segment(p, s.a, s.b)), expected,
                1e-12 * (1.0 + expected));
    ASSERT_EQ(nearest->distance_m, distance(p, nearest->at));
  });
}

TEST(SegmentIndex, ClearanceIsTheNearestDistanceUpToTheLimit) {
  for_random_scenes(14, 300, [](const Scene& scene, Point p, Point, Random& random) {
    const double limit = random.uniform(0.0, 20.0);
    const double expected = std::min(limit, nearest_distance(p, scene.segments));
    ASSERT_NEAR(scene.index.clearance_m(p, limit), expected, 1e-12 * (1.0 + expected));
    ASSERT_LE(scene.index.clearance_m(p, limit), limit);
  });
}

TEST(SegmentIndex, MeetsWhenSomeSegmentDoes) {
  for_random_scenes(15, 400, [](const Scene& scene, Point a, Point b, Random&) {
    const bool expected = std::any_of(
        scene.segments.begin(), scene.segments.end(),
        [&](const IndexedSegment& s) { return meet(a, b, s.a, s.b).kind != Meeting::kNone; });
    ASSERT_EQ(scene.index.meets(a, b), expected);
  });
}

TEST(SegmentIndex, QueryMeetingFindsAllThatMeet) {
  for_random_scenes(18, 200, [](const Scene& scene, Point a, Point b, Random&) {
    std::vector<std::size_t> expected, found;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
      const auto& s = scene.segments[i];
      if (meet(a, b, s.a, s.b).kind != Meeting::kNone) expected.push_back(i);
    }
    ASSERT_TRUE(scene.index.query_meeting(a, b, [&](std::size_t i) {
      found.push_back(i);
      return true;
    }));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  });
}

TEST(SegmentIndex, ComesNearWhenSomeSegmentDoes) {
  for_random_scenes(16, 400, [](const Scene& scene, Point a, Point b, Random& random) {
    double nearest = HUGE_VAL;
    for (const auto& s : scene.segments) nearest = std::min(nearest, segment_distance(a, b, s));
    const double radius = random.uniform(0.0, 3.0);
    if (std::abs(radius - nearest) > 1e-12) {
      ASSERT_EQ(scene.index.comes_near(a, b, radius), nearest < radius);
    }
    ASSERT_EQ(scene.index.comes_near(a, b, nearest + 1e-9), true);
    ASSERT_EQ(scene.index.comes_near(a, b, std::max(0.0, nearest - 1e-9)), false);
  });
}

TEST(SegmentIndex, OfNothing) {
  const SegmentIndex index({});
  EXPECT_FALSE(index.nearest({0, 0}).has_value());
  EXPECT_EQ(index.clearance_m({0, 0}, 5.0), 5.0);
  EXPECT_FALSE(index.meets({0, 0}, {1, 1}));
  EXPECT_FALSE(index.comes_near({0, 0}, {1, 1}, 1.0));
}

TEST(MeetingPairs, AreThoseOfBruteForce) {
  Random random(17);
  for (int i = 0; i < 200; ++i) {
    std::vector<Box> boxes;
    for (const auto& s : random_segments(random, random.below(150))) {
      boxes.push_back(box_around(s.a, s.b));
    }
    if (i % 3 == 0 && !boxes.empty()) boxes.push_back(kEmptyBox);
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      for (std::size_t q = p + 1; q < boxes.size(); ++q) {
        if (meet_closed(boxes[p], boxes[q])) expected.insert({p, q});
      }
    }
    for_each_meeting_pair(boxes, [&](std::size_t p, std::size_t q) {
      EXPECT_TRUE(found.insert({p, q}).second) << "twice";
    });
    ASSERT_EQ(found, expected);
  }
}

// Boxes of one size, as buildings are, and boxes of all sizes; each grown by a reach.
TEST(MeetingPairs, OfGrownBoxesAreThoseOfBruteForce) {
  Random random(18);
  for (int i = 0; i < 200; ++i) {
    const double reach_m = i % 4 == 0 ? 0.0 : random.uniform(0.0, 1.0);
    const double most_m = i % 3 == 0 ? 60.0 : 3.0;
    std::vector<Box> boxes;
    for (auto left = random.below(300); left > 0; --left) {
      const Point low{std::round(random.uniform(-50.0, 50.0)), random.uniform(-40.0, 40.0)};
      boxes.push_back({low.x, low.y, low.x + std::round(random.uniform(0.0, most_m)),
                       low.y + random.uniform(0.0, most_m)});
      if (left % 50 == 0) boxes.push_back(kEmptyBox);
    }
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      for (std::size_t q = p + 1; q < boxes.size(); ++q) {
        const bool is_there = !boxes[p].is_empty() && !boxes[q].is_empty();
        if (is_there && meet_closed(boxes[p].inflated(reach_m), boxes[q].inflated(reach_m))) {
          expected.insert({p, q});
        }
      }
    }
    const auto add = [&](std::size_t p, std::size_t q) {
      EXPECT_TRUE(found.insert({p, q}).second) << "twice";
    };
    for_each_meeting_pair(boxes, add, reach_m);
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace mapwright
