#include <gtest/gtest.h>

#include "mapcore/random.hpp"
#include "navcore/exact/line_work.hpp"

namespace mapwright::navcore::exact {
namespace {

bool crosses(const LineWork& work, const Edge& p, const Edge& q) {
  const GridPoint a = work.vertices[p.a], b = work.vertices[p.b];
  const GridPoint c = work.vertices[q.a], d = work.vertices[q.b];
  for (const auto& [v, e] : {std::pair(a, q), std::pair(b, q), std::pair(c, p), std::pair(d, p)}) {
    const GridPoint from = work.vertices[e.a], to = work.vertices[e.b];
    if (v != from && v != to && is_on_segment(v, from, to)) return true;
  }
  const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
  return sign(orient(a, b, c)) * sign(orient(a, b, d)) < 0 &&
         sign(orient(c, d, a)) * sign(orient(c, d, b)) < 0;
}

void expect_noded(const LineWork& work) {
  for (std::size_t i = 0; i < work.edges.size(); ++i) {
    for (std::size_t j = i + 1; j < work.edges.size(); ++j) {
      ASSERT_FALSE(crosses(work, work.edges[i], work.edges[j])) << i << " " << j;
    }
  }
}

TEST(Noding, CutsACrossOnTheGridWithoutMovingAnything) {
  const LineWork work = node({{{0, 0}, {10, 10}, 1}, {{0, 10}, {10, 0}, 2}});
  EXPECT_EQ(work.vertices.size(), 5U);
  EXPECT_EQ(work.edges.size(), 4U);
  EXPECT_EQ(work.displacement_mm, 0.0);
}

TEST(Noding, RoundsACrossingBetweenGridPointsAndSaysSo) {
  const LineWork work = node({{{0, 0}, {9, 10}, 1}, {{0, 10}, {10, 1}, 2}});
  expect_noded(work);
  EXPECT_GT(work.displacement_mm, 0.0);
}

TEST(Noding, JoinsOverlapsAndKeepsAllSources) {
  const LineWork work = node({{{0, 0}, {10, 0}, 1}, {{20, 0}, {5, 0}, 2}, {{7, 7}, {7, 7}, 3}});
  ASSERT_EQ(work.edges.size(), 3U);
  const Edge& shared = work.edges[1];
  ASSERT_EQ(shared.last_piece - shared.first_piece, 2U);
  EXPECT_EQ(work.pieces[shared.first_piece].source, 1U);
  EXPECT_FALSE(work.pieces[shared.first_piece].reversed);
  EXPECT_EQ(work.pieces[shared.first_piece + 1].source, 2U);
  EXPECT_TRUE(work.pieces[shared.first_piece + 1].reversed);
}

TEST(Noding, CutsAWallWhereAnotherEndsOnIt) {
  const LineWork work = node({{{0, 0}, {10, 0}, 1}, {{4, 0}, {4, 9}, 2}});
  EXPECT_EQ(work.edges.size(), 3U);
  EXPECT_EQ(work.displacement_mm, 0.0);
}

TEST(Noding, LeavesNoCrossingAmongRandomLines) {
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    const auto size = 10 + random.below(round % 2 == 0 ? 20 : 2000);
    const auto draw = [&] {
      return GridPoint{static_cast<std::int32_t>(random.below(size)),
                       static_cast<std::int32_t>(random.below(size))};
    };
    std::vector<Line> lines;
    for (std::uint32_t i = 0; i < 40; ++i) lines.push_back({draw(), draw(), i});
    const LineWork work = node(lines);
    expect_noded(work);
    EXPECT_LE(work.displacement_mm, 1.5);
  }
}

// Every line can still be followed from its start to its end: a closed outline stays closed.
TEST(Noding, KeepsEachLineConnected) {
  Random random(6);
  std::vector<Line> lines;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const auto draw = [&] {
      return GridPoint{static_cast<std::int32_t>(random.below(500)),
                       static_cast<std::int32_t>(random.below(500))};
    };
    lines.push_back({draw(), draw(), i});
  }
  const LineWork work = node(lines);
  std::vector<std::int64_t> sum_x(60), sum_y(60);
  for (const Edge& edge : work.edges) {
    for (std::uint32_t i = edge.first_piece; i < edge.last_piece; ++i) {
      const Piece piece = work.pieces[i];
      const GridPoint a = work.vertices[piece.reversed ? edge.b : edge.a];
      const GridPoint b = work.vertices[piece.reversed ? edge.a : edge.b];
      sum_x[piece.source] += b.x - a.x;
      sum_y[piece.source] += b.y - a.y;
    }
  }
  for (const Line& line : lines) {
    EXPECT_EQ(sum_x[line.source], line.b.x - line.a.x);
    EXPECT_EQ(sum_y[line.source], line.b.y - line.a.y);
  }
}

}  // namespace
}  // namespace mapwright::navcore::exact
