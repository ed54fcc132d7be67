#include "navcore/exact/barrier_proof.hpp"

#include <algorithm>
#include <limits>

#include "navcore/exact/barrier.hpp"
#include "navcore/exact/free_faces.hpp"

namespace mapwright::navcore {
namespace {

using exact::GridPoint;
using exact::Line;

Point to_point(GridPoint p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

double distance_mm(GridPoint p, const Line& line) {
  return distance(to_point(p),
                  closest_point_on_segment(to_point(p), to_point(line.a), to_point(line.b)));
}

// How far p is from the line, and from the line's point nearest to the other end of its gap.
double offside_mm(GridPoint p, GridPoint other, const Line& line) {
  const Point foot = closest_point_on_segment(to_point(other), to_point(line.a), to_point(line.b));
  return distance_mm(p, line) + distance(to_point(p), foot);
}

// The line for which `measure` is least, not counting line `other`.
template <class Measure>
std::uint32_t best_line(const std::vector<Line>& lines, std::uint32_t other, Measure measure) {
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const double value = i == other ? least : measure(lines[i]);
    if (value < least) least = value, best = i;
  }
  return best;
}

// Only guesses which lines a side runs along; `separates` judges the guess.
exact::BarrierLeg to_leg(const BarrierSide& side, const std::vector<Line>& lines,
                         const exact::GridFrame& frame) {
  constexpr std::uint32_t kNoLine = std::numeric_limits<std::uint32_t>::max();
  exact::BarrierLeg leg{frame.to_grid(side.from), frame.to_grid(side.to), 0, 0};
  if (!side.is_gap) {
    leg.line_from = leg.line_to = best_line(lines, kNoLine, [&](const Line& line) {
      return std::max(distance_mm(leg.from, line), distance_mm(leg.to, line));
    });
    return leg;
  }
  leg.line_from = best_line(lines, kNoLine,
                            [&](const Line& line) { return offside_mm(leg.from, leg.to, line); });
  leg.line_to = best_line(lines, leg.line_from,
                          [&](const Line& line) { return offside_mm(leg.to, leg.from, line); });
  return leg;
}

bool can_hold_all(const exact::GridFrame& frame, std::span<const BarrierSide> barrier, Point start,
                  Point goal) {
  return frame.can_hold(start) && frame.can_hold(goal) &&
         std::all_of(barrier.begin(), barrier.end(), [&](const BarrierSide& side) {
           return frame.can_hold(side.from) && frame.can_hold(side.to);
         });
}

}  // namespace

bool proves_unreachable(const Map& map, RampPolicy ramps, std::span<const BarrierSide> barrier,
                        Point start, Point goal, double radius_m) {
  const exact::GridFrame frame(
      {0.5 * (map.border.left + map.border.right), 0.5 * (map.border.top + map.border.bottom)});
  const auto segments = blocking_segments(map, ramps);
  const bool fits = std::all_of(segments.begin(), segments.end(), [&](const BlockingSegment& s) {
    return frame.can_hold(s.a) && frame.can_hold(s.b);
  });
  if (!fits || !can_hold_all(frame, barrier, start, goal)) return false;
  if (!(radius_m >= 0.0) || radius_m * 1e3 > exact::kMapLimit) return false;
  exact::Barrier on_grid{{}, exact::map_lines(map, segments, frame)};
  for (const BarrierSide& side : barrier) {
    on_grid.legs.push_back(to_leg(side, on_grid.lines, frame));
  }
  return exact::separates(on_grid, frame.to_grid(start), frame.to_grid(goal),
                          static_cast<std::int64_t>(radius_m * 1e9));
}

}  // namespace mapwright::navcore
