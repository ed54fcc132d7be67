#include "mapcore/parts/cut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mapcore/geometry/orientation.hpp"
#include "mapcore/geometry/ring_repair.hpp"
#include "mapcore/parts/cut_record.hpp"
#include "mapcore/parts/piece_keys.hpp"

namespace mapwright {
namespace {

constexpr const char* kCutEdge = "cut";

// A side of the box: what lies to its inner side has `inside(p) >= 0`.
struct Side {
  Point normal;
  double offset;
  double inside(Point p) const { return dot(normal, p) - offset; }
};

std::vector<Side> sides_of(const Box& box) {
  return {{{1, 0}, box.min_x}, {{-1, 0}, -box.max_x}, {{0, 1}, box.min_y}, {{0, -1}, -box.max_y}};
}

// Where an edge crosses a side: the same point whichever way round the edge runs.
Point crossing(const Side& side, Point a, Point b) {
  if (a.x > b.x || (a.x == b.x && a.y > b.y)) std::swap(a, b);
  const double at_a = side.inside(a), at_b = side.inside(b);
  Point p = a + (at_a / (at_a - at_b)) * (b - a);
  if (side.normal.x != 0.0) p.x = side.offset * side.normal.x;
  if (side.normal.y != 0.0) p.y = side.offset * side.normal.y;
  return p;
}

// The piece of a segment in the box; nothing where it only passes or touches it at a point.
std::optional<std::pair<Point, Point>> piece_of(const Box& box, Point a, Point b) {
  for (const auto& side : sides_of(box)) {
    const bool a_in = side.inside(a) >= 0.0, b_in = side.inside(b) >= 0.0;
    if (!a_in && !b_in) return std::nullopt;
    if (!a_in) a = crossing(side, a, b);
    if (!b_in) b = crossing(side, a, b);
  }
  if (a == b) return std::nullopt;
  return std::pair(a, b);
}

}  // namespace

Cutter::Cutter(const Map& map, const Box& box, double resolution_m)
    : map_(map), box_(box), format_(resolution_m), resolution_m_(resolution_m) {
  for (const auto& obstacle : map.obstacles) last_id_ = std::max(last_id_, obstacle.id);
}

// Sutherland and Hodgman (1974): pieces of a ring that is not convex hang together along the box,
// where their edges lie on each other; the odd-even rule takes those away.
Cutter::Ring Cutter::clipped(const Ring& ring) const {
  Ring points = ring;
  for (const auto& side : sides_of(box_)) {
    Ring kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point a = points[i], b = points[i + 1 == points.size() ? 0 : i + 1];
      const bool a_in = side.inside(a) >= 0.0, b_in = side.inside(b) >= 0.0;
      if (a_in) kept.push_back(a);
      if (a_in != b_in) kept.push_back(crossing(side, a, b));
    }
    points = std::move(kept);
  }
  Ring clean;
  for (const Point p : points) {
    const Point q = snapped(p);
    if (clean.empty() || clean.back() != q) clean.push_back(q);
  }
  while (clean.size() > 1 && clean.front() == clean.back()) clean.pop_back();
  return clean;
}

bool Cutter::is_solid(std::span<const std::size_t> family) const {
  const auto is_outline = [&](std::size_t i) {
    const auto& o = map_.obstacles[i];
    const bool joined = !o.segments.empty() && o.segments.back().b == o.segments.front().a;
    return (o.shape_type == ShapeType::kClosedPolygon || o.shape_type == ShapeType::kClosedCurve) &&
           joined && is_simple_ring(chain_points(o));
  };
  if (!std::all_of(family.begin(), family.end(), is_outline)) return false;
  return std::any_of(family.begin(), family.end(), [&](std::size_t i) {
    return ring_orientation(chain_points(map_.obstacles[i])) == RingOrientation::kCounterClockwise;
  });
}

// The segment of the family that the edge is a piece of gives it its values; an edge along the cut
// has none and is as high as the solid.
Segment Cutter::edge_of(Point a, Point b, std::span<const std::size_t> family) const {
  const Point middle = 0.5 * (a + b);
  const Segment* nearest = nullptr;
  double least_m = 2.0 * resolution_m_;
  double height_m = 0.0;
  for (const std::size_t i : family) {
    height_m = std::max(height_m, max_height_m(map_.obstacles[i]));
    for (const auto& s : map_.obstacles[i].segments) {
      if (dot(s.b - s.a, b - a) <= 0.0) continue;
      const double off_m = distance(closest_point_on_segment(middle, s.a, s.b), middle);
      if (off_m > least_m || (nearest != nullptr && off_m == least_m)) continue;
      least_m = off_m;
      nearest = &s;
    }
  }
  const bool is_cut = nearest == nullptr;
  const auto& first = map_.obstacles[family.front()].segments.front();
  return {a, b, is_cut ? height_m : nearest->height_m, is_cut ? first.in_out : nearest->in_out,
          is_cut ? Semantic(kCutEdge) : nearest->semantic};
}

Obstacle Cutter::outline_of(const Ring& ring, const Obstacle& like,
                            std::span<const std::size_t> family) const {
  Obstacle piece;
  piece.id = like.id;
  piece.shape_type = like.shape_type;
  piece.semantic = like.semantic;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    piece.segments.push_back(edge_of(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], family));
  }
  return piece;
}

// A hole that nothing was cut off keeps its record.
const Obstacle* Cutter::untouched_hole(const Ring& ring,
                                       std::span<const std::size_t> family) const {
  for (const std::size_t i : family.subspan(1)) {
    const auto points = chain_points(map_.obstacles[i]);
    if (std::is_permutation(points.begin(), points.end(), ring.begin(), ring.end())) {
      return &map_.obstacles[i];
    }
  }
  return nullptr;
}

void Cutter::append_hole(const Ring& ring, const std::string& outline_id,
                         std::span<const std::size_t> family, std::vector<Obstacle>& part) {
  const auto* whole = untouched_hole(ring, family);
  Obstacle hole =
      whole != nullptr ? *whole : outline_of(ring, map_.obstacles[family.front()], family);
  if (whole == nullptr) hole.id = ++last_id_;
  if (hole.semantic.value(semantic_key::kInnerOf) != outline_id) {
    hole.semantic = hole.semantic.with_value(semantic_key::kInnerOf, outline_id);
  }
  part.push_back(std::move(hole));
}

void Cutter::cut_solid(std::span<const std::size_t> family, std::vector<Obstacle>& part) {
  std::vector<Ring> rings;
  for (const std::size_t i : family) {
    Ring ring = clipped(chain_points(map_.obstacles[i]));
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  const auto polygons = odd_even_polygons(rings, [this](Point p) { return snapped(p); });
  if (!polygons) {  // what cannot be clipped stays whole
    for (const std::size_t i : family) part.push_back(map_.obstacles[i]);
    return;
  }
  const Obstacle& outline = map_.obstacles[family.front()];
  std::vector<const Obstacle*> members;
  for (const std::size_t i : family) members.push_back(&map_.obstacles[i]);
  for (const auto& polygon : *polygons) {
    Obstacle piece = outline_of(polygon.outer, outline, family);
    if (&polygon == &polygons->front()) {
      leave_record(members, piece);
    } else {
      piece.id = ++last_id_;
      piece.semantic = piece.semantic.with_value(piece_key::kPartOf, std::to_string(outline.id));
    }
    const std::string id = std::to_string(piece.id);
    part.push_back(std::move(piece));
    for (const auto& ring : polygon.holes) append_hole(ring, id, family, part);
  }
}

void Cutter::cut_chain(const Obstacle& obstacle, std::vector<Obstacle>& part) {
  std::vector<Obstacle> pieces;
  for (const auto& segment : obstacle.segments) {
    const auto ends = piece_of(box_, segment.a, segment.b);
    if (!ends) continue;
    Segment left = segment;
    left.a = snapped(ends->first);
    left.b = snapped(ends->second);
    if (left.a == left.b) continue;
    const bool goes_on = !pieces.empty() && pieces.back().segments.back().b == left.a;
    if (!goes_on) {
      pieces.push_back({obstacle.id, obstacle.shape_type, obstacle.semantic, {}});
    }
    pieces.back().segments.push_back(std::move(left));
  }
  // A ring that was cut begins in the middle of its first piece.
  if (pieces.size() > 1 && pieces.back().segments.back().b == pieces.front().segments.front().a) {
    auto& last = pieces.back().segments;
    last.insert(last.end(), pieces.front().segments.begin(), pieces.front().segments.end());
    std::swap(pieces.front(), pieces.back());
    pieces.pop_back();
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    auto& piece = pieces[i];
    const bool closes = piece.segments.back().b == piece.segments.front().a;
    if (is_closed(piece.shape_type) && !closes) {
      piece.shape_type = piece.shape_type == ShapeType::kClosedCurve ? ShapeType::kOpenCurve
                                                                     : ShapeType::kOpenPolygon;
    }
    if (i == 0) {
      const Obstacle* whole = &obstacle;
      leave_record({&whole, 1}, piece);
    } else {
      piece.id = ++last_id_;
      piece.semantic = piece.semantic.with_value(piece_key::kPartOf, std::to_string(obstacle.id));
    }
    part.push_back(std::move(piece));
  }
}

void Cutter::leave_record(std::span<const Obstacle* const> family, Obstacle& piece) const {
  piece.semantic =
      piece.semantic.with_value(piece_key::kCut, format_cut_record(resolution_m_, family));
}

std::size_t Cutter::cut(std::span<const std::size_t> family, std::vector<Obstacle>& part) {
  if (is_solid(family)) {
    cut_solid(family, part);
    return family.size();
  }
  std::size_t altered = 0;
  for (const std::size_t i : family) {
    const auto& obstacle = map_.obstacles[i];
    const bool is_within =
        std::all_of(obstacle.segments.begin(), obstacle.segments.end(),
                    [&](const Segment& s) { return box_.contains(s.a) && box_.contains(s.b); });
    const bool stays_whole = is_within || obstacle.shape_type == ShapeType::kStairs ||
                             obstacle.shape_type == ShapeType::kRamp;
    if (stays_whole) {
      part.push_back(obstacle);
    } else {
      cut_chain(obstacle, part);
      ++altered;
    }
  }
  return altered;
}

}  // namespace mapwright
