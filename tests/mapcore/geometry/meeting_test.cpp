#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "mapcore/geometry/orientation.hpp"
#include "tests/mapcore/geometry/generators.hpp"

namespace mapwright {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_2 to_cgal(Point p) {
  return {p.x, p.y};
}

Point to_point(const Kernel::Point_2& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

bool is_one_of(Point p, Point a, Point b, Point c, Point d) {
  return p == a || p == b || p == c || p == d;
}

SegmentMeeting meet_exactly(Point a, Point b, Point c, Point d) {
  const Kernel::Segment_2 s(to_cgal(a), to_cgal(b)), t(to_cgal(c), to_cgal(d));
  if (s.is_degenerate()) return {t.has_on(s.source()) ? Meeting::kTouch : Meeting::kNone, a};
  if (t.is_degenerate()) return {s.has_on(t.source()) ? Meeting::kTouch : Meeting::kNone, c};
  const auto common = CGAL::intersection(s, t);
  if (!common) return {};
  if (const auto* piece = boost::get<Kernel::Segment_2>(&*common)) {
    return {Meeting::kOverlap, to_point(CGAL::midpoint(piece->source(), piece->target()))};
  }
  const Point at = to_point(boost::get<Kernel::Point_2>(*common));
  const bool at_end = s.source() == boost::get<Kernel::Point_2>(*common) ||
                      s.target() == boost::get<Kernel::Point_2>(*common) ||
                      t.source() == boost::get<Kernel::Point_2>(*common) ||
                      t.target() == boost::get<Kernel::Point_2>(*common);
  return {at_end ? Meeting::kTouch : Meeting::kCross, at};
}

TEST(Meet, NamesTheFourWays) {
  EXPECT_EQ(meet({0, 0}, {2, 2}, {0, 2}, {2, 0}).kind, Meeting::kCross);
  EXPECT_EQ(meet({0, 0}, {2, 2}, {0, 2}, {2, 0}).at, (Point{1, 1}));
  EXPECT_EQ(meet({0, 0}, {2, 0}, {1, 0}, {1, 5}).kind, Meeting::kTouch);
  EXPECT_EQ(meet({0, 0}, {2, 0}, {1, 0}, {5, 0}).kind, Meeting::kOverlap);
  EXPECT_EQ(meet({0, 0}, {2, 0}, {1, 0}, {5, 0}).at, (Point{1.5, 0}));
  EXPECT_EQ(meet({0, 0}, {2, 0}, {2, 0}, {5, 0}).kind, Meeting::kTouch);
  EXPECT_EQ(meet({0, 0}, {2, 0}, {3, 0}, {5, 0}).kind, Meeting::kNone);
  EXPECT_EQ(meet({1, 0}, {1, 0}, {0, 0}, {5, 0}).kind, Meeting::kTouch);
  EXPECT_EQ(meet({1, 0}, {1, 0}, {1, 0}, {1, 0}).kind, Meeting::kTouch);
  EXPECT_EQ(meet({1, 1}, {1, 1}, {0, 0}, {5, 0}).kind, Meeting::kNone);
}

TEST(Meet, EqualsExactConstructions) {
  Random random(4);
  for (int i = 0; i < 50'000; ++i) {
    const auto p = test::random_points(random, 4);
    const auto found = meet(p[0], p[1], p[2], p[3]);
    const auto expected = meet_exactly(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(found.kind, expected.kind) << i;
    if (found.kind == Meeting::kNone) continue;
    ASSERT_LE(distance(found.at, expected.at), 1e-11) << i;
    if (found.kind == Meeting::kTouch) {
      ASSERT_TRUE(is_one_of(found.at, p[0], p[1], p[2], p[3]));
    }
  }
}

TEST(Meet, DoesNotDependOnOrderOrDirection) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const auto p = test::random_points(random, 4);
    const auto kind = meet(p[0], p[1], p[2], p[3]).kind;
    ASSERT_EQ(meet(p[2], p[3], p[0], p[1]).kind, kind);
    ASSERT_EQ(meet(p[1], p[0], p[3], p[2]).kind, kind);
  }
}

TEST(Meet, FindsTheCrossingOfNearlyParallelSegments) {
  // The lines cross at (500000, 500000.5) under an angle of a few 1e-12.
  const auto meeting = meet({0, 0}, {1e6, 1e6 + 1}, {0, 1e-6}, {1e6, 1e6 + 1 - 1e-6});
  ASSERT_EQ(meeting.kind, Meeting::kCross);
  EXPECT_LE(distance(meeting.at,
                     meet_exactly({0, 0}, {1e6, 1e6 + 1}, {0, 1e-6}, {1e6, 1e6 + 1 - 1e-6}).at),
            1e-9);
}

}  // namespace
}  // namespace mapwright
