#include "converter/pipeline/leaning_walls.hpp"

#include <algorithm>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/segment_index.hpp"

namespace mapwright::converter {
namespace {

bool is_ring(const Draft& draft) {
  const auto type = draft.obstacle.shape_type;
  return is_closed(type) && type != ShapeType::kRamp;
}

bool is_wall(const Draft& draft) {
  return draft.kind != FeatureKind::kObstacle && is_open_chain(draft.obstacle.shape_type);
}

bool meet(const Box& p, const Box& q) {
  return p.min_x <= q.max_x && q.min_x <= p.max_x && p.min_y <= q.max_y && q.min_y <= p.max_y;
}

// Box around all walls.
Box extent_of_walls(const std::vector<Draft>& drafts) {
  Box all = kEmptyBox;
  for (const auto& draft : drafts) {
    if (!is_wall(draft)) continue;
    for (const auto& segment : draft.obstacle.segments) {
      all.add(segment.a);
      all.add(segment.b);
    }
  }
  return all;
}

// Edges of the rings that walls can lean on.
SegmentIndex ring_edges(const std::vector<Draft>& drafts, const Box& walls) {
  std::vector<IndexedSegment> edges;
  for (const auto& draft : drafts) {
    if (!is_ring(draft) || !meet(extent(draft.obstacle), walls)) continue;
    for (const auto& segment : draft.obstacle.segments) edges.push_back({segment.a, segment.b, 0});
  }
  return SegmentIndex(std::move(edges));
}

enum class Lean { kNot, kRight, kWrong };

// How a wall segment lies on outlines: right where one of them runs its way.
Lean lean_of(const Segment& segment, const SegmentIndex& edges) {
  Box box = kEmptyBox;
  box.add(segment.a);
  box.add(segment.b);
  Lean lean = Lean::kNot;
  edges.query(box, [&](std::size_t i) {
    const auto& edge = edges[i];
    if (meet(segment.a, segment.b, edge.a, edge.b).kind != Meeting::kOverlap) return true;
    lean = dot(segment.b - segment.a, edge.b - edge.a) > 0.0 ? Lean::kRight : Lean::kWrong;
    return lean != Lean::kRight;
  });
  return lean;
}

bool leans_wrongly(const Obstacle& wall, const SegmentIndex& edges) {
  bool wrong = false;
  for (const auto& segment : wall.segments) {
    const auto lean = lean_of(segment, edges);
    if (lean == Lean::kRight) return false;
    wrong = wrong || lean == Lean::kWrong;
  }
  return wrong;
}

void reverse(Obstacle& wall) {
  std::reverse(wall.segments.begin(), wall.segments.end());
  for (auto& segment : wall.segments) std::swap(segment.a, segment.b);
}

}  // namespace

void turn_leaning_walls(Workspace& workspace) {
  const Box walls = extent_of_walls(workspace.drafts);
  if (walls.is_empty()) return;
  const auto edges = ring_edges(workspace.drafts, walls);
  for (auto& draft : workspace.drafts) {
    if (!is_wall(draft) || !leans_wrongly(draft.obstacle, edges)) continue;
    reverse(draft.obstacle);
    for (const std::size_t account : draft.features) {
      workspace.ledger.change(
          account, FindingCode::C228,
          "the line lies on the outline of a solid with its free side towards it and "
          "was turned");
    }
  }
}

}  // namespace mapwright::converter
