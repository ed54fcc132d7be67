#include "mapcore/diff/obstacle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mapwright {
namespace {

constexpr double kHashGrid_m = 1.0e-6;  // finer than any map is written, coarser than arithmetic

// SplitMix64's finaliser.
std::uint64_t mixed(std::uint64_t value) {
  value ^= value >> 30U;
  value *= 0xBF58476D1CE4E5B9;
  value ^= value >> 27U;
  value *= 0x94D049BB133111EB;
  return value ^ (value >> 31U);
}

void add(std::uint64_t& hash, double difference_m) {
  const double units = std::round(difference_m / kHashGrid_m);
  // Beyond any map; a number that does not fit must not be converted.
  const auto whole = std::abs(units) < 9.0e18 ? static_cast<std::int64_t>(units) : INT64_MAX;
  hash = mixed(hash ^ static_cast<std::uint64_t>(whole));
}

bool comes_before(Point p, Point q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

std::size_t first_segment(const Obstacle& obstacle) {
  if (!is_ring(obstacle)) return 0;
  const auto& segments = obstacle.segments;
  const auto lowest =
      std::min_element(segments.begin(), segments.end(),
                       [](const Segment& p, const Segment& q) { return comes_before(p.a, q.a); });
  return static_cast<std::size_t>(lowest - segments.begin());
}

}  // namespace

bool is_ring(const Obstacle& obstacle) {
  const auto& segments = obstacle.segments;
  if (segments.size() < 2 || segments.back().b != segments.front().a) return false;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (segments[i - 1].b != segments[i].a) return false;
  }
  return true;
}

ObstacleShape shape_of(const Obstacle& obstacle) {
  ObstacleShape shape;
  const std::size_t count = obstacle.segments.size();
  shape.hash = mixed(count);
  if (count == 0) return shape;
  shape.first = first_segment(obstacle);
  shape.anchor = obstacle.segments[shape.first].a;
  shape.box = extent(obstacle);
  for (std::size_t k = 0; k < count; ++k) {
    const Segment& segment = obstacle.segments[shape.position(k, count)];
    for (const Point end : {segment.a, segment.b}) {
      add(shape.hash, end.x - shape.anchor.x);
      add(shape.hash, end.y - shape.anchor.y);
    }
  }
  return shape;
}

Obstacle reversed(const Obstacle& obstacle) {
  Obstacle other = obstacle;
  std::reverse(other.segments.begin(), other.segments.end());
  for (auto& segment : other.segments) std::swap(segment.a, segment.b);
  return other;
}

}  // namespace mapwright
