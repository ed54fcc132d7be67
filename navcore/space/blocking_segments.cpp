#include <cstdint>

#include "navcore/free_space.hpp"
#include "navcore/space/stairs_outline.hpp"

namespace mapwright::navcore {
namespace {

void add(std::vector<BlockingSegment>& blocking, Point a, Point b, std::size_t obstacle,
         std::optional<std::uint32_t> segment = std::nullopt) {
  if (is_finite(a) && is_finite(b)) {
    blocking.push_back({a, b, static_cast<std::uint32_t>(obstacle), segment});
  }
}

void add(std::vector<BlockingSegment>& blocking, const Obstacle& from, std::size_t obstacle,
         std::uint32_t number) {
  add(blocking, from.segments[number].a, from.segments[number].b, obstacle, number);
}

void add_flank(std::vector<BlockingSegment>& blocking, const std::vector<Point>& flank,
               std::size_t obstacle) {
  for (std::size_t i = 1; i < flank.size(); ++i) {
    if (flank[i - 1] != flank[i]) add(blocking, flank[i - 1], flank[i], obstacle);
  }
}

void add_stairs(std::vector<BlockingSegment>& blocking, const Obstacle& stairs,
                std::size_t obstacle) {
  for (std::uint32_t i = 0; i < stairs.segments.size(); ++i) add(blocking, stairs, obstacle, i);
  const StairsFlanks flanks = stairs_flanks(stairs);
  add_flank(blocking, flanks.near_a, obstacle);
  add_flank(blocking, flanks.near_b, obstacle);
}

}  // namespace

std::vector<BlockingSegment> blocking_segments(const Map& map, RampPolicy ramps) {
  std::vector<BlockingSegment> blocking;
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const Obstacle& obstacle = map.obstacles[i];
    if (obstacle.shape_type == ShapeType::kStairs) {
      add_stairs(blocking, obstacle, i);
      continue;
    }
    const bool all = obstacle.shape_type == ShapeType::kRamp && ramps == RampPolicy::kAvoid;
    for (std::uint32_t j = 0; j < obstacle.segments.size(); ++j) {
      if (all || obstacle.segments[j].height_m > 0.0) add(blocking, obstacle, i, j);
    }
  }
  return blocking;
}

}  // namespace mapwright::navcore
