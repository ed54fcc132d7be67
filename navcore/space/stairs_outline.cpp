#include "navcore/space/stairs_outline.hpp"

namespace mapwright::navcore {

StairsFlanks stairs_flanks(const Obstacle& stairs) {
  StairsFlanks flanks;
  Point direction{};
  for (const auto& segment : stairs.segments) {
    const bool opposed = dot(segment.b - segment.a, direction) < 0.0;
    const Point a = opposed ? segment.b : segment.a;
    const Point b = opposed ? segment.a : segment.b;
    flanks.near_a.push_back(a);
    flanks.near_b.push_back(b);
    direction = b - a;
  }
  return flanks;
}

std::vector<Point> stairs_outline(const Obstacle& stairs) {
  if (stairs.segments.size() < 2) return {};
  const StairsFlanks flanks = stairs_flanks(stairs);
  std::vector<Point> ring(flanks.near_b.begin(), flanks.near_b.end());
  ring.insert(ring.end(), flanks.near_a.rbegin(), flanks.near_a.rend());
  return ring;
}

}  // namespace mapwright::navcore
