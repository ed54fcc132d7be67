#include <optional>

#include "navcore/exact/barrier.hpp"

namespace mapwright::navcore::exact {
namespace {

__extension__ using Wide = __int128;

Wide square(std::int64_t value) {
  return Wide{value} * value;
}

// True if p is nearer to the line than `limit_mm`, or on it.
bool is_near(GridPoint p, const Line& line, std::int64_t limit_mm) {
  if (is_on_segment(p, line.a, line.b)) return true;
  if (dot_from(line.a, line.b, p) <= 0) return squared_distance(p, line.a) < square(limit_mm);
  if (dot_from(line.b, line.a, p) <= 0) return squared_distance(p, line.b) < square(limit_mm);
  return square(orient(line.a, line.b, p)) < square(limit_mm) * squared_distance(line.a, line.b);
}

bool blocks(const Barrier& barrier, const BarrierLeg& leg, std::int64_t radius_mm) {
  if (leg.line_from >= barrier.lines.size() || leg.line_to >= barrier.lines.size()) return false;
  const Line &from = barrier.lines[leg.line_from], &to = barrier.lines[leg.line_to];
  if (!leg.is_gap()) return is_near(leg.from, from, radius_mm) && is_near(leg.to, from, radius_mm);
  return radius_mm > 1 && is_near(leg.from, from, 1) && is_near(leg.to, to, 1) &&
         squared_distance(leg.from, leg.to) < square(2 * radius_mm - 2);
}

// Nothing where p lies on the polygon.
std::optional<int> winding_number(const std::vector<BarrierLeg>& polygon, GridPoint p) {
  int winding = 0;
  for (const BarrierLeg& leg : polygon) {
    if (is_on_segment(p, leg.from, leg.to)) return std::nullopt;
    const bool starts_below = leg.from.y <= p.y, ends_below = leg.to.y <= p.y;
    if (starts_below == ends_below) continue;
    const bool is_left = orient(leg.from, leg.to, p) > 0;
    if (starts_below && is_left) ++winding;
    if (!starts_below && !is_left) --winding;
  }
  return winding;
}

}  // namespace

bool separates(const Barrier& barrier, GridPoint start, GridPoint goal, std::int64_t radius_mm) {
  const auto& legs = barrier.legs;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].to != legs[(i + 1) % legs.size()].from) return false;
    if (!blocks(barrier, legs[i], radius_mm)) return false;
  }
  const auto around_start = winding_number(legs, start), around_goal = winding_number(legs, goal);
  return around_start && around_goal && *around_start != *around_goal;
}

}  // namespace mapwright::navcore::exact
