#include "navcore/engine/scene.hpp"

#include <algorithm>
#include <limits>

#include "navcore/engine/simple_ring.hpp"

namespace mapwright::navcore::engine {
namespace {

bool closes(std::span<const SceneSegment> chain) {
  if (chain.size() < 3) return false;
  Point end = chain.back().b;
  for (const SceneSegment& segment : chain) {
    if (segment.a != end) return false;
    end = segment.b;
  }
  return true;
}

void note_ring(SceneObstacle& obstacle, std::span<const SceneSegment> chain) {
  if (obstacle.stairs || !closes(chain)) return;
  std::vector<Point> ring;
  ring.reserve(chain.size());
  for (const SceneSegment& segment : chain) ring.push_back(segment.a);
  const RingShape shape = ring_shape(ring);
  obstacle.simple_ring = shape != RingShape::kUnclear;
  obstacle.counter_clockwise = shape == RingShape::kCounterClockwise;
}

Box box_of(std::span<const Point> points) {
  Box box = kEmptyBox;
  for (const Point p : points) box.add(p);
  return box;
}

}  // namespace

Scene::Scene(const Map& map) {
  const std::size_t segments = segment_count(map);
  segments_.reserve(segments);
  obstacle_of_.reserve(segments);
  obstacles_.reserve(map.obstacles.size());
  for (const Obstacle& obstacle : map.obstacles) {
    if (obstacle.shape_type == ShapeType::kRamp) {
      add_ramp(obstacle);
    } else {
      add(obstacle);
    }
  }
  std::vector<BinItem> items;
  items.reserve(segments_.size() + ramps_.size());
  for (const SceneSegment& segment : segments_)
    items.push_back(BinItem::segment(segment.a, segment.b));
  for (const SceneRamp& ramp : ramps_) items.push_back(BinItem::area(box_of(ramp.footprint)));
  bins_ = ItemBins(items);
}

void Scene::add(const Obstacle& obstacle) {
  SceneObstacle entry;
  entry.first = static_cast<std::uint32_t>(segments_.size());
  entry.stairs = obstacle.shape_type == ShapeType::kStairs;
  entry.min_height_m = std::numeric_limits<double>::infinity();
  for (const Segment& segment : obstacle.segments) {
    if (segment.a == segment.b) continue;
    segments_.push_back({segment.a, segment.b, segment.height_m});
    obstacle_of_.push_back(static_cast<std::uint32_t>(obstacles_.size()));
    entry.min_height_m = std::min(entry.min_height_m, segment.height_m);
    entry.box.add(segment.a);
    entry.box.add(segment.b);
  }
  entry.count = static_cast<std::uint32_t>(segments_.size()) - entry.first;
  note_ring(entry, segments_of(entry));
  obstacles_.push_back(entry);
}

void Scene::add_ramp(const Obstacle& obstacle) {
  const auto normal = ramp_normal(obstacle);
  if (!normal || normal->z <= 0.0 || obstacle.segments.empty()) return;
  std::vector<Point> footprint = chain_points(obstacle);
  const RampPlane plane(*normal, footprint);
  if (plane.gradient() == Point{0.0, 0.0}) return;
  ramps_.push_back({plane, std::move(footprint)});
}

std::size_t Scene::memory_bytes() const {
  std::size_t bytes = segments_.capacity() * sizeof(SceneSegment) +
                      obstacle_of_.capacity() * sizeof(std::uint32_t) +
                      obstacles_.capacity() * sizeof(SceneObstacle) + bins_.memory_bytes();
  for (const SceneRamp& ramp : ramps_) {
    bytes += sizeof(SceneRamp) + ramp.footprint.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace mapwright::navcore::engine
