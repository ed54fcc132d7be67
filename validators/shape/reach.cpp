#include "validators/shape/reach.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace mapwright::validators {
namespace {

// A piece between two points of an outline lies no deeper than half its length.
bool is_too_short(const Piece& piece, double depth_m) {
  return distance(piece.from, piece.to) <= 2.0 * depth_m;
}

Box box_of(const Segment& segment) {
  Box box = kEmptyBox;
  box.add(segment.a);
  box.add(segment.b);
  return box;
}

std::vector<std::uint32_t> blocking_segments_near(const EdgeFinder& edges, const Box& box) {
  std::vector<std::uint32_t> near;
  edges.visit(box, [&](std::uint32_t k) {
    if (edges.obstacle().segments[k].height_m > 0.0) near.push_back(k);
  });
  std::sort(near.begin(), near.end());
  return near;
}

// The first piece for which `is_sought` holds, of the obstacle's segments that come near `box`, cut
// by the edges that `visit_edges(box, visit)` gives.
template <class VisitEdges, class IsSought>
std::optional<Reach> first_piece(const CheckContext& context, std::uint32_t obstacle,
                                 const Box& box, const VisitEdges& visit_edges,
                                 const IsSought& is_sought) {
  const auto& obstacles = context.map().obstacles;
  std::vector<Cut> cuts;
  for (const auto k : blocking_segments_near(context.edges(obstacle), box)) {
    const Segment& segment = obstacles[obstacle].segments[k];
    cuts.clear();
    visit_edges(box_of(segment), [&](std::uint32_t other, std::uint32_t e) {
      add_cuts(segment, obstacles[other].segments[e], other, e, cuts);
    });
    const auto pieces = pieces_of(segment, cuts);
    const auto sought = std::find_if(pieces.begin(), pieces.end(), is_sought);
    if (sought != pieces.end()) return Reach{k, *sought};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Reach> reach_into(const CheckContext& context, const Region& region,
                                std::uint32_t obstacle, double depth_m) {
  const auto edges = [&](const Box& box, const auto& visit) { region.visit_edges(box, visit); };
  return first_piece(
      context, obstacle, context.box(region.outer()), edges, [&](const Piece& piece) {
        return !is_too_short(piece, depth_m) && region.holds(piece.middle(), depth_m);
      });
}

std::optional<Reach> reach_across(const CheckContext& context, std::uint32_t ring,
                                  std::uint32_t obstacle, double depth_m) {
  const EdgeFinder& outline = context.edges(ring);
  const auto edges = [&](const Box& box, const auto& visit) {
    outline.visit(box, [&](std::uint32_t e) { visit(ring, e); });
  };
  std::optional<PointSide> side_before;
  std::optional<Point> end_before;
  const auto changes_side = [&](const Piece& piece) {
    if (end_before != piece.from) side_before.reset();
    end_before = piece.to;
    if (is_too_short(piece, depth_m) || outline.distance_m(piece.middle()) <= depth_m) return false;
    const PointSide side = outline.side(piece.middle());
    return std::exchange(side_before, side).value_or(side) != side;
  };
  return first_piece(context, obstacle, context.box(ring), edges, changes_side);
}

bool lies_wholly_inside(const CheckContext& context, const Region& region, std::uint32_t obstacle,
                        double depth_m) {
  const auto& obstacles = context.map().obstacles;
  const auto meets_an_edge = [&](const Segment& segment) {
    bool meets = false;
    region.visit_edges(box_of(segment), [&](std::uint32_t outline, std::uint32_t e) {
      const Segment& edge = obstacles[outline].segments[e];
      meets = meets || meet(segment.a, segment.b, edge.a, edge.b).kind != Meeting::kNone;
    });
    return meets;
  };
  const auto& segments = obstacles[obstacle].segments;
  return !segments.empty() && region.holds(segments.front().a, depth_m) &&
         std::none_of(segments.begin(), segments.end(), meets_an_edge);
}

}  // namespace mapwright::validators
