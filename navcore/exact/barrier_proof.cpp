#include "navcore/exact/barrier_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

double distance_off_mm(GridPoint p, const std::vector<Line>& lines) {
  double least_mm = 1.0;
  for (const Line& line : lines) {
    if (!is_on_segment(p, line.a, line.b)) least_mm = std::min(least_mm, distance_mm(p, line));
  }
  return least_mm;
}

// Directions in which lines leave p, as the hands of a clock run backwards.
std::vector<exact::Direction> spokes(GridPoint p, const std::vector<Line>& lines) {
  std::vector<exact::Direction> found;
  const auto add = [&](GridPoint end) {
    if (end != p) found.push_back({std::int64_t{end.x} - p.x, std::int64_t{end.y} - p.y});
  };
  for (const Line& line : lines) {
    if (is_on_segment(p, line.a, line.b)) add(line.a), add(line.b);
  }
  const auto angle = [](exact::Direction d) {
    return std::atan2(static_cast<double>(d.y), static_cast<double>(d.x));
  };
  std::sort(found.begin(), found.end(),
            [&](exact::Direction c, exact::Direction d) { return angle(c) < angle(d); });
  const auto last = std::unique(found.begin(), found.end(), [&](auto c, auto d) {
    return c.x * d.y == c.y * d.x && angle(c) == angle(d);
  });
  found.erase(last, found.end());
  return found;
}

// Half-way between two directions, counter-clockwise from the first to the second.
exact::Direction between(exact::Direction c, exact::Direction d) {
  constexpr double kLength = 1e6;
  const double from = std::atan2(static_cast<double>(c.y), static_cast<double>(c.x));
  double to = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x));
  if (to <= from) to += 2.0 * std::numbers::pi;
  return {std::llround(kLength * std::cos(0.5 * (from + to))),
          std::llround(kLength * std::sin(0.5 * (from + to)))};
}

// For a place on a line: a way into each sector between lines there that is free. Tried in the map
// itself, nearer to the place than any other line.
exact::BarrierEnd end_at(Point place, const exact::GridFrame& frame, const std::vector<Line>& lines,
                         const FreeSpace& space) {
  exact::BarrierEnd end{frame.to_grid(place), {}};
  const auto around = spokes(end.at, lines);
  const double step_m = 0.5e-3 * distance_off_mm(end.at, lines);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const exact::Direction way = between(around[i], around[(i + 1) % around.size()]);
    const Point unit{static_cast<double>(way.x) / 1e6, static_cast<double>(way.y) / 1e6};
    if (space.is_free(frame.to_map(end.at) + step_m * unit)) end.ways_off.push_back(way);
  }
  return end;
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
  const auto radius_nm = static_cast<std::int64_t>(radius_m * 1e9);
  if (radius_nm > 0) {
    return exact::separates(on_grid, frame.to_grid(start), frame.to_grid(goal), radius_nm);
  }
  const FreeSpace space(map, ramps);
  return exact::separates_ways_off(on_grid, end_at(start, frame, on_grid.lines, space),
                                   end_at(goal, frame, on_grid.lines, space), radius_nm);
}

}  // namespace mapwright::navcore
