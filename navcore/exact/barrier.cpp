#include "navcore/exact/barrier.hpp"

#include <cmath>
#include <limits>

#include "navcore/exact/barrier_rounds.hpp"
#include "navcore/exact/boundary.hpp"

namespace mapwright::navcore::exact {
namespace {

// Lines, in the order in which a closed curve keeps away from them.
using LineRound = std::vector<Line>;

Line line_along(const LineWork& work, std::uint32_t edge_number) {
  const Edge& edge = work.edges[edge_number];
  return {work.vertices[edge.a], work.vertices[edge.b], work.pieces[edge.first_piece].source};
}

LineRound lines_around(const BoundaryCycle& cycle, const Tessellation& base,
                       const Tessellation& space) {
  std::vector<std::uint32_t> edges;
  for (const BoundarySide& side : cycle) {
    const std::uint32_t first_piece = space.work.edges[side.edge].first_piece;
    const std::uint32_t edge = &base == &space ? side.edge : space.work.pieces[first_piece].source;
    if (edges.empty() || edges.back() != edge) edges.push_back(edge);
  }
  while (edges.size() > 1 && edges.back() == edges.front()) edges.pop_back();
  LineRound round;
  for (const std::uint32_t edge : edges) round.push_back(line_along(base.work, edge));
  return round;
}

LineRound lines_around(const SiteRound& sites, const Tessellation& base) {
  LineRound round;
  for (const VoronoiSite& site : sites) {
    round.push_back({site.a, site.b, line_along(base.work, site.edge).source});
  }
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

// The polygon that runs along the lines and takes the shortest way from each to the next.
Barrier polygon_along(LineRound round) {
  Barrier barrier{{}, std::move(round)};
  const auto n = static_cast<std::uint32_t>(barrier.lines.size());
  if (n == 0) return barrier;
  const auto step_after = [&](std::uint32_t i) {
    return closest_pair(barrier.lines[i], barrier.lines[(i + 1) % n]);
  };
  ClosePair before = step_after(n - 1);
  for (std::uint32_t i = 0; i < n; ++i) {
    const ClosePair step = step_after(i);
    if (before.on_second != step.on_first) {
      barrier.legs.push_back({before.on_second, step.on_first, i, i});
    }
    if (step.on_first != step.on_second) {
      barrier.legs.push_back({step.on_first, step.on_second, i, (i + 1) % n});
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

// Keeps the shortest of the polygons that separate.
class Shortest {
 public:
  Shortest(const BarrierEnd& start, const BarrierEnd& goal, std::int64_t radius_nm)
      : start_(start), goal_(goal), radius_nm_(radius_nm) {}

  void consider(Barrier barrier) {
    const double length_mm = perimeter_mm(barrier);
    if (length_mm >= shortest_mm_) return;
    if (!separates_ways_off(barrier, start_, goal_, radius_nm_)) return;
    shortest_mm_ = length_mm;
    best_ = std::move(barrier);
  }

  std::optional<Barrier> take() {
    if (std::isinf(shortest_mm_)) return std::nullopt;
    return std::move(best_);
  }

 private:
  const BarrierEnd &start_, &goal_;
  std::int64_t radius_nm_;
  Barrier best_;
  double shortest_mm_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<Barrier> find_barrier(const Tessellation& base, const Tessellation& space,
                                    const BarrierEnd& start, const BarrierEnd& goal,
                                    std::int64_t radius_nm) {
  Shortest shortest(start, goal, radius_nm);
  for (const BoundaryCycle& cycle : boundary_cycles(space)) {
    shortest.consider(polygon_along(lines_around(cycle, base, space)));
  }
  return shortest.take();
}

std::optional<Barrier> find_barrier(const Tessellation& base, const std::vector<SiteRound>& rounds,
                                    const BarrierEnd& start, const BarrierEnd& goal,
                                    std::int64_t radius_nm) {
  Shortest shortest(start, goal, radius_nm);
  for (const SiteRound& sites : rounds) shortest.consider(polygon_along(lines_around(sites, base)));
  return shortest.take();
}

}  // namespace mapwright::navcore::exact
