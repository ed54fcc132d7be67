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

bool is_wall(const PlainObstacle& plain) {
  return is_open_chain(plain.shape_type);
}

Box extent_of(std::span<const Point> chain) {
  Box box = kEmptyBox;
  for (const Point p : chain) box.add(p);
  return box;
}

// Calls `visit(a, b)` for each segment.
template <class Visit>
void for_each_segment(const PlainObstacle& plain, std::span<const Point> chain,
                      const Visit& visit) {
  for (std::size_t i = 0; i < plain.segment_count(); ++i) {
    visit(chain[i], chain[i + 1 == chain.size() ? 0 : i + 1]);
  }
}

// Box around all walls.
Box extent_of_walls(const Workspace& workspace) {
  Box all = kEmptyBox;
  std::vector<Point> room;
  for (const auto& plain : workspace.plain.all()) {
    if (!is_wall(plain)) continue;
    for (const Point p : workspace.plain.chain(plain, room)) all.add(p);
  }
  for (const auto& draft : workspace.drafts) {
    if (!is_wall(draft)) continue;
    for (const auto& segment : draft.obstacle.segments) {
      all.add(segment.a);
      all.add(segment.b);
    }
  }
  return all;
}

// Edges of the rings that walls can lean on.
SegmentIndex ring_edges(const Workspace& workspace, const Box& walls) {
  std::vector<IndexedSegment> edges;
  std::vector<Point> room;
  for (const auto& plain : workspace.plain.all()) {
    if (is_wall(plain)) continue;
    const auto chain = workspace.plain.chain(plain, room);
    if (!meet(extent_of(chain), walls)) continue;
    for_each_segment(plain, chain, [&](Point a, Point b) { edges.push_back({a, b, 0}); });
  }
  for (const auto& draft : workspace.drafts) {
    if (!is_ring(draft) || !meet(extent(draft.obstacle), walls)) continue;
    for (const auto& segment : draft.obstacle.segments) edges.push_back({segment.a, segment.b, 0});
  }
  return SegmentIndex(std::move(edges));
}

enum class Lean { kNot, kRight, kWrong };

// How a wall segment lies on outlines: right where one of them runs its way.
Lean lean_of(Point a, Point b, const SegmentIndex& edges) {
  Box box = kEmptyBox;
  box.add(a);
  box.add(b);
  Lean lean = Lean::kNot;
  edges.query(box, [&](std::size_t i) {
    const auto& edge = edges[i];
    if (meet(a, b, edge.a, edge.b).kind != Meeting::kOverlap) return true;
    lean = dot(b - a, edge.b - edge.a) > 0.0 ? Lean::kRight : Lean::kWrong;
    return lean != Lean::kRight;
  });
  return lean;
}

// Gathers how the segments of a wall lean.
class WallLean {
 public:
  explicit WallLean(const SegmentIndex& edges) : edges_(edges) {}
  void add(Point a, Point b) {
    if (is_right_) return;
    const auto lean = lean_of(a, b, edges_);
    is_right_ = lean == Lean::kRight;
    is_wrong_ = is_wrong_ || lean == Lean::kWrong;
  }
  bool is_wrong() const { return is_wrong_ && !is_right_; }

 private:
  const SegmentIndex& edges_;
  bool is_right_ = false;
  bool is_wrong_ = false;
};

bool leans_wrongly(const Obstacle& wall, const SegmentIndex& edges) {
  WallLean lean(edges);
  for (const auto& segment : wall.segments) lean.add(segment.a, segment.b);
  return lean.is_wrong();
}

bool leans_wrongly(const PlainObstacle& wall, std::span<const Point> chain,
                   const SegmentIndex& edges) {
  WallLean lean(edges);
  for_each_segment(wall, chain, [&](Point a, Point b) { lean.add(a, b); });
  return lean.is_wrong();
}

void reverse(Obstacle& wall) {
  std::reverse(wall.segments.begin(), wall.segments.end());
  for (auto& segment : wall.segments) std::swap(segment.a, segment.b);
}

void say_turned(std::size_t account, Ledger& ledger) {
  ledger.change(account, FindingCode::C228,
                "the line lies on the outline of a solid with its free side towards it and "
                "was turned");
}

}  // namespace

void turn_leaning_walls(Workspace& workspace) {
  const Box walls = extent_of_walls(workspace);
  if (walls.is_empty()) return;
  const auto edges = ring_edges(workspace, walls);
  for (auto& draft : workspace.drafts) {
    if (!is_wall(draft) || !leans_wrongly(draft.obstacle, edges)) continue;
    reverse(draft.obstacle);
    for (const std::size_t account : draft.features) say_turned(account, workspace.ledger);
  }
  std::vector<Point> room;
  for (auto& plain : workspace.plain.all()) {
    if (!is_wall(plain)) continue;
    if (!leans_wrongly(plain, workspace.plain.chain(plain, room), edges)) continue;
    PlainObstacles::reverse(plain);
    say_turned(plain.account, workspace.ledger);
  }
}

}  // namespace mapwright::converter
