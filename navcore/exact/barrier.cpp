#include "navcore/exact/barrier.hpp"

#include <limits>
#include <unordered_map>

#include "navcore/exact/boundary.hpp"

namespace mapwright::navcore::exact {
namespace {

// Edges of the base, in the order in which a boundary cycle keeps away from them.
using EdgeRound = std::vector<std::uint32_t>;

EdgeRound edges_around(const BoundaryCycle& cycle, const Tessellation& base,
                       const Tessellation& space) {
  EdgeRound round;
  for (const BoundarySide& side : cycle) {
    const std::uint32_t first_piece = space.work.edges[side.edge].first_piece;
    const std::uint32_t edge = &base == &space ? side.edge : space.work.pieces[first_piece].source;
    if (round.empty() || round.back() != edge) round.push_back(edge);
  }
  while (round.size() > 1 && round.back() == round.front()) round.pop_back();
  return round;
}

struct ClosePair {
  GridPoint on_first, on_second;
};

GridPoint nearest_on(const Line& line, GridPoint p) {
  const Point a{static_cast<double>(line.a.x), static_cast<double>(line.a.y)};
  const Point b{static_cast<double>(line.b.x), static_cast<double>(line.b.y)};
  const Point q =
      closest_point_on_segment({static_cast<double>(p.x), static_cast<double>(p.y)}, a, b);
  return {static_cast<std::int32_t>(std::nearbyint(q.x)),
          static_cast<std::int32_t>(std::nearbyint(q.y))};
}

// Where two lines that do not cross are nearest to each other: at an end of one of them.
ClosePair closest_pair(const Line& p, const Line& q) {
  const ClosePair candidates[] = {{p.a, nearest_on(q, p.a)},
                                  {p.b, nearest_on(q, p.b)},
                                  {nearest_on(p, q.a), q.a},
                                  {nearest_on(p, q.b), q.b}};
  ClosePair best = candidates[0];
  for (const ClosePair& pair : candidates) {
    if (squared_distance(pair.on_first, pair.on_second) <
        squared_distance(best.on_first, best.on_second)) {
      best = pair;
    }
  }
  return best;
}

// The lines along the edges, each once, and for each edge of the round its line.
std::vector<std::uint32_t> add_lines(const EdgeRound& round, const LineWork& work,
                                     std::vector<Line>& lines) {
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> line_of;
  for (const std::uint32_t edge_number : round) {
    const auto [place, is_new] =
        numbers.emplace(edge_number, static_cast<std::uint32_t>(lines.size()));
    line_of.push_back(place->second);
    if (!is_new) continue;
    const Edge& edge = work.edges[edge_number];
    lines.push_back(
        {work.vertices[edge.a], work.vertices[edge.b], work.pieces[edge.first_piece].source});
  }
  return line_of;
}

// The polygon that runs along the edges and takes the shortest way from each to the next.
Barrier polygon_along(const EdgeRound& round, const LineWork& work) {
  Barrier barrier;
  const std::vector<std::uint32_t> line_of = add_lines(round, work, barrier.lines);
  const std::size_t n = line_of.size();
  const auto step_after = [&](std::size_t i) {
    return closest_pair(barrier.lines[line_of[i]], barrier.lines[line_of[(i + 1) % n]]);
  };
  ClosePair before = step_after(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const ClosePair step = step_after(i);
    if (before.on_second != step.on_first) {
      barrier.legs.push_back({before.on_second, step.on_first, line_of[i], line_of[i]});
    }
    if (step.on_first != step.on_second) {
      barrier.legs.push_back({step.on_first, step.on_second, line_of[i], line_of[(i + 1) % n]});
    }
    before = step;
  }
  return barrier;
}

double perimeter_mm(const Barrier& barrier) {
  double sum = 0.0;
  for (const BarrierLeg& leg : barrier.legs) sum += distance_mm(leg.from, leg.to);
  return sum;
}

}  // namespace

std::optional<Barrier> find_barrier(const Tessellation& base, const Tessellation& space,
                                    GridPoint start, GridPoint goal, std::int64_t radius_nm) {
  std::optional<Barrier> best;
  double shortest_mm = std::numeric_limits<double>::infinity();
  for (const BoundaryCycle& cycle : boundary_cycles(space)) {
    Barrier barrier = polygon_along(edges_around(cycle, base, space), base.work);
    const double length_mm = perimeter_mm(barrier);
    if (length_mm >= shortest_mm || !separates(barrier, start, goal, radius_nm)) continue;
    shortest_mm = length_mm;
    best = std::move(barrier);
  }
  return best;
}

}  // namespace mapwright::navcore::exact
