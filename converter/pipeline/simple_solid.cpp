#include "converter/pipeline/simple_solid.hpp"

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"

namespace mapwright::converter {
namespace {

// A ring in metres and in units of the resolution.
struct RoundedRing {
  std::span<const Point> points;
  std::span<GridPoint> grid_points;
};

// The rounded ring of a path that says its first point again at its end and no other point twice
// in a row; empty for others. `room` holds as many points as the path.
RoundedRing ring_of(const SourceGeometry& geometry, const SourcePath& path, GridPoint* room,
                    Workspace& workspace) {
  constexpr std::size_t kLeastPoints = 4;
  if (path.count < kLeastPoints) return {};
  workspace.ring.resize(path.count);
  Point* const points = workspace.ring.data();
  bool repeats = false;
  for (std::size_t i = 0; i < path.count; ++i) {
    points[i] = {geometry.xs[path.first + i], geometry.ys[path.first + i]};
    repeats = repeats || (i > 0 && points[i] == points[i - 1]);
  }
  static_assert(sizeof(Point) == 2 * sizeof(double));
  if (repeats || !workspace.resolution.round({&points->x, 2 * path.count}, &room->x)) return {};
  const std::span<GridPoint> all(room, path.count);
  if (!(all.front() == all.back())) return {};
  // Points that fall together when rounded are no matter of words, but rare.
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return {};
  return {{points, path.count - 1}, all.first(path.count - 1)};
}

// The first vertex stays the first.
bool orient(const RoundedRing& ring, RingOrientation wanted) {
  const auto found = ring_orientation(ring.points);
  if (found == RingOrientation::kDegenerate) return false;
  if (found != wanted) std::reverse(ring.grid_points.begin() + 1, ring.grid_points.end());
  return true;
}

}  // namespace

bool add_simple_solid(const FeatureTask& task, Workspace& workspace) {
  const auto& geometry = task.feature.geometry;
  if (!task.is_plain || !workspace.repair || geometry.paths.size() != 1) return false;
  const auto& path = geometry.paths.front();
  if (path.role != PathRole::kOuterRing) return false;
  GridPoint* const room = workspace.plain.room_for(path.count);
  const auto ring = ring_of(geometry, path, room, workspace);
  const bool is_room = task.meaning.rule->kind == FeatureKind::kRoom;
  const auto wanted = is_room ? RingOrientation::kClockwise : RingOrientation::kCounterClockwise;
  if (ring.points.empty() || !is_simple_ring(ring.points) || !orient(ring, wanted)) {
    workspace.plain.give_back(path.count);
    return false;
  }
  workspace.plain.give_back(path.count - ring.points.size());
  PlainObstacle plain;
  plain.grid_points = ring.grid_points.data();
  plain.count = static_cast<std::uint32_t>(ring.points.size());
  plain.shape_type = path.curved ? ShapeType::kClosedCurve : ShapeType::kClosedPolygon;
  plain.joined = true;
  finish_plain(task, plain, height_of(task, workspace), workspace);
  return true;
}

}  // namespace mapwright::converter
