#include "converter/pipeline/simple_solid.hpp"

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// The rounded ring of a path that says its first point again at its end and no other point twice
// in a row; empty for others. `room` holds as many points as the path.
std::span<Point> ring_of(const SourceGeometry& geometry, const SourcePath& path,
                         const text::DecimalFormat& resolution, Point* room) {
  constexpr std::size_t kLeastPoints = 4;
  if (path.count < kLeastPoints) return {};
  for (std::size_t i = 0; i < path.count; ++i) {
    room[i] = {geometry.xs[path.first + i], geometry.ys[path.first + i]};
    if (i > 0 && room[i] == room[i - 1]) return {};
  }
  static_assert(sizeof(Point) == 2 * sizeof(double));
  resolution.round({&room[0].x, 2 * path.count});
  const std::span<Point> all(room, path.count);
  if (!(all.front() == all.back())) return {};
  const auto ring = all.first(path.count - 1);
  // Points that fall together when rounded are no matter of words, but rare.
  return std::adjacent_find(all.begin(), all.end()) == all.end() ? ring : std::span<Point>();
}

bool orient(std::span<Point> ring, RingOrientation wanted) {
  const auto found = ring_orientation(ring);
  if (found == RingOrientation::kDegenerate) return false;
  // The first vertex stays the first.
  if (found != wanted) std::reverse(ring.begin() + 1, ring.end());
  return true;
}

}  // namespace

bool add_simple_solid(const FeatureTask& task, Workspace& workspace) {
  const auto& geometry = task.feature.geometry;
  if (!task.is_plain || !workspace.repair || geometry.paths.size() != 1) return false;
  const auto& path = geometry.paths.front();
  if (path.role != PathRole::kOuterRing) return false;
  Point* const room = workspace.plain.room_for(path.count);
  const auto ring = ring_of(geometry, path, workspace.resolution, room);
  const bool is_room = task.meaning.rule->kind == FeatureKind::kRoom;
  const auto wanted = is_room ? RingOrientation::kClockwise : RingOrientation::kCounterClockwise;
  if (ring.empty() || !is_simple_ring(ring) || !orient(ring, wanted)) {
    workspace.plain.give_back(path.count);
    return false;
  }
  workspace.plain.give_back(path.count - ring.size());
  PlainObstacle plain;
  plain.points = ring.data();
  plain.count = static_cast<std::uint32_t>(ring.size());
  plain.shape_type = path.curved ? ShapeType::kClosedCurve : ShapeType::kClosedPolygon;
  plain.joined = true;
  finish_plain(task, plain, height_of(task, workspace), workspace);
  return true;
}

}  // namespace mapwright::converter
