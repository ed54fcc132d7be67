#include "validators/shape/branches.hpp"

#include <algorithm>
#include <tuple>

namespace mapwright::validators {
namespace {

bool is_before(Point p, Point q) {
  return std::tie(p.x, p.y) < std::tie(q.x, q.y);
}

// The ends of all segments that have a length, sorted.
std::vector<Point> sorted_ends(const Obstacle& obstacle) {
  std::vector<Point> ends;
  ends.reserve(2 * obstacle.segments.size());
  for (std::size_t k = 0; k < obstacle.segments.size(); ++k) {
    const Segment& segment = obstacle.segments[k];
    if (segment.a == segment.b || (k > 0 && repeats_the_one_before(obstacle, k))) continue;
    ends.push_back(segment.a);
    ends.push_back(segment.b);
  }
  std::sort(ends.begin(), ends.end(), is_before);
  return ends;
}

}  // namespace

bool repeats_the_one_before(const Obstacle& obstacle, std::size_t k) {
  const Segment &segment = obstacle.segments[k], &before = obstacle.segments[k - 1];
  return segment.a == before.a && segment.b == before.b;
}

std::vector<bool> branches_of(const Obstacle& obstacle) {
  const auto ends = sorted_ends(obstacle);
  std::vector<bool> branches(obstacle.segments.size(), false);
  for (std::size_t k = 1; k < obstacle.segments.size(); ++k) {
    const Point start = obstacle.segments[k].a;
    if (obstacle.segments[k - 1].b == start || repeats_the_one_before(obstacle, k)) continue;
    const auto [from, to] = std::equal_range(ends.begin(), ends.end(), start, is_before);
    branches[k] = to - from > 2;
  }
  return branches;
}

}  // namespace mapwright::validators
