#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "mapcore/geometry/exact_arithmetic.hpp"
#include "mapcore/geometry/filtered_turn.hpp"
#include "mapcore/geometry/orientation.hpp"

namespace mapwright {
namespace {

// Below this many vertices, trying every pair of edges is faster than a sweep.
constexpr std::size_t kFewVertices = 24;

Point next_vertex(std::span<const Point> ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

bool has_zero_length_edge(std::span<const Point> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] == next_vertex(ring, i)) return true;
  }
  return false;
}

bool has_repeated_vertex(std::span<const Point> ring) {
  std::vector<Point> sorted;
  sorted.assign(ring.begin(), ring.end());
  std::sort(sorted.begin(), sorted.end(),
            [](Point p, Point q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); });
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

// True if the ring turns back on itself at b. Requires three different points.
bool is_spike(Point a, Point b, Point c) {
  if (sure_turn(a, b, c) != 0) return false;
  if (turn(a, b, c) != Turn::kStraight) return false;
  const auto between = [](double from, double to, double value) {
    return (from < value && value < to) || (to < value && value < from);
  };
  return !between(a.x, c.x, b.x) && !between(a.y, c.y, b.y);
}

bool has_spike(std::span<const Point> ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point before = ring[i == 0 ? ring.size() - 1 : i - 1];
    if (is_spike(before, ring[i], next_vertex(ring, i))) return true;
  }
  return false;
}

bool boxes_meet(Point a, Point b, Point c, Point d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

// Two edges that do not share a vertex, after doubles could not tell.
bool edges_meet(std::span<const Point> ring, std::size_t i, std::size_t j) {
  const Point a = ring[i], b = next_vertex(ring, i);
  const Point c = ring[j], d = next_vertex(ring, j);
  return boxes_meet(a, b, c, d) && meet(a, b, c, d).kind != Meeting::kNone;
}

// Whether two vertices that follow each other lie for certain on one side of an edge, none on it.
bool are_apart(int side_of_first, int side_of_second) {
  return side_of_first != 0 && side_of_first == side_of_second;
}

bool some_distant_edges_meet(std::span<const Point> ring) {
  for (std::size_t i = 0; i + 2 < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1];
    const std::size_t last = i == 0 ? ring.size() - 1 : ring.size();
    int side = sure_turn(a, b, ring[i + 2]);
    for (std::size_t j = i + 2; j < last; ++j) {
      const Point c = ring[j], d = next_vertex(ring, j);
      const int before = side;
      side = sure_turn(a, b, d);
      if (are_apart(before, side)) continue;
      if (are_apart(sure_turn(c, d, a), sure_turn(c, d, b))) continue;
      if (edges_meet(ring, i, j)) return true;
    }
  }
  return false;
}

enum class Turns {
  kUnsure,  // somewhere only exact arithmetic can tell: vertices may coincide, edges turn back
  kMixed,
  kOnce,  // to one side at every vertex, and once around: the ring is convex
};

// Edges whose directions turn by less than half a turn each, to one side, change between leftwards
// and rightwards twice when they go once around.
Turns turns_of(std::span<const Point> ring) {
  Point before = ring.back();
  int sides = 0, changes = 0, first_way = 0, way = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point here = ring[i], next = next_vertex(ring, i);
    const int side = sure_turn(before, here, next);
    if (side == 0) return Turns::kUnsure;
    sides += side;
    before = here;
    if (next.x == here.x) continue;
    const int now = next.x > here.x ? 1 : -1;
    changes += way != 0 && now != way ? 1 : 0;
    way = now;
    if (first_way == 0) first_way = now;
  }
  changes += way != first_way ? 1 : 0;
  const bool one_sided = std::abs(sides) == static_cast<int>(ring.size());
  return one_sided && changes == 2 ? Turns::kOnce : Turns::kMixed;
}

}  // namespace

bool is_simple_ring(std::span<const Point> ring) {
  if (ring.size() < 3) return false;
  const Turns turns = turns_of(ring);
  if (turns == Turns::kOnce) return true;
  if (turns == Turns::kUnsure && (has_zero_length_edge(ring) || has_spike(ring))) return false;
  if (ring.size() <= kFewVertices) return !some_distant_edges_meet(ring);
  // CGAL's sweep may answer wrongly where a vertex stands twice, so that is settled first.
  return !has_repeated_vertex(ring) && exact::is_simple(ring);
}

}  // namespace mapwright
